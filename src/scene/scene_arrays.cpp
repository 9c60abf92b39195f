#include <inkedge/scene_arrays.h>

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "base/message.h"
#include "mesh/number_array.h"

namespace inkedge {
namespace {

glm::dmat4 transformOf(const mesh::NumberArray& numbers, std::size_t row) {
    glm::dmat4 transform;
    bool finite = true;
    for (std::size_t i = 0; i < 16; ++i) {
        const double number = numbers.real(row, i);
        finite = finite && std::isfinite(number);
        transform[static_cast<int>(i % 4)][static_cast<int>(i / 4)] = number;
    }
    const bool affine =
        transform[0][3] == 0.0 && transform[1][3] == 0.0 && transform[2][3] == 0.0 && transform[3][3] == 1.0;
    if (!finite || !affine)
        base::refuseUse(fmt::format(
            "transforms: expected finite matrices whose last row is 0, 0, 0, 1, found another: number {}", row));
    return transform;
}

std::vector<glm::dmat4> transformsOf(const ArrayView& view) {
    const mesh::NumberArray numbers{view, "transforms"};
    numbers.expectReal();
    numbers.expectColumns(16);
    std::vector<glm::dmat4> transforms;
    for (std::size_t row = 0; row < numbers.rows(); ++row) transforms.push_back(transformOf(numbers, row));
    if (transforms.empty()) transforms.emplace_back(1.0);
    return transforms;
}

void add(Scene::Data& data, const InstancedArrays& arrays) {
    const std::vector<glm::dmat4> transforms = transformsOf(arrays.transforms);
    if (!arrays.names.empty() && arrays.names.size() != transforms.size())
        base::refuseUse(
            fmt::format("names: expected {}, one an instance, found {}", transforms.size(), arrays.names.size()));
    const auto number = static_cast<std::uint32_t>(data.meshes.size());
    data.meshes.push_back(makeMesh(arrays.mesh));
    for (std::size_t i = 0; i < transforms.size(); ++i)
        data.instances.push_back({arrays.names.empty() ? arrays.mesh.name : arrays.names[i], number, transforms[i]});
}

}  // namespace

Scene makeScene(std::span<const InstancedArrays> all, const LoadSettings& settings) {
    Scene::Data data;
    data.source.unit = settings.unit;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all.size() == 1)
            add(data, all[i]);
        else
            base::within(base::label("mesh", i, all[i].mesh.name), [&] { add(data, all[i]); });
    }
    return Scene{std::move(data), settings};
}

}  // namespace inkedge
