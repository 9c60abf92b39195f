#include "formats/gltf/mask_uses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/message.h"
#include "formats/gltf/attributes.h"
#include "formats/gltf/paint.h"
#include "formats/gltf/triangles.h"
#include "mesh/twice_area.h"

namespace inkedge::gltf {
namespace {

constexpr double opaque = 255.0;

void add(const std::array<glm::dvec2, 3>& corners, MaskUse& use) {
    const double area = 0.5 * std::abs(mesh::twiceArea(corners[0], corners[1], corners[2]));
    double edges = 0.0;
    for (std::size_t k = 0; k < 3; ++k) edges += glm::distance(corners[k], corners[(k + 1) % 3]);
    constexpr double largest = 1e6;  // what repeats a picture more often is refused when it is cut
    if (!(area < largest && edges < largest)) return;
    use.area += area;
    use.edges += edges;
    use.triangles += 1.0;
}

// One primitive's use of its mask.
class Reader {
public:
    Reader(const tinygltf::Model& model, const File& file, std::uint64_t maxElements)
        : model_{model}, file_{file}, elementsLeft_{maxElements} {}

    void read(const tinygltf::Primitive& primitive) {
        const Mode mode{primitive.mode};
        const Material* const material = materialOf(file_, primitive);
        if (material == nullptr || material->alpha != Material::Alpha::Mask || !material->texture ||
            !material->texture->image || *material->texture->image >= file_.images.size() || !drawsTriangles(mode))
            return;
        const auto position = primitive.attributes.find("POSITION");
        if (position == primitive.attributes.end()) return;
        const std::uint64_t count = elementCount(model_, position->second, "POSITION");
        spend(count);
        const std::vector<glm::dvec2> uvs = uvsOf(model_, *material->texture, primitive, count);
        if (uvs.empty()) return;
        const std::vector<std::uint32_t> triangles = triangleList(mode, cornersOf(model_, file_, primitive, count));
        spend(triangles.size());
        MaskUse& use = uses_[{*material->texture->image, material->cutoff / material->opacity}];
        for (std::size_t i = 0; i < triangles.size(); i += 3)
            add({uvs[triangles[i]], uvs[triangles[i + 1]], uvs[triangles[i + 2]]}, use);
        use.varies = use.varies || varies(vertexOpacities(model_, primitive, count), triangles);
    }

    [[nodiscard]] std::vector<MaskUse> uses() const {
        std::vector<MaskUse> all;
        for (const auto& [of, use] : uses_) {
            all.push_back(use);
            all.back().image = of.first;
            all.back().threshold = opaque * of.second;
        }
        return all;
    }

private:
    void spend(std::uint64_t elements) {
        if (elements > elementsLeft_) base::refuse("expected fewer vertices, found more");
        elementsLeft_ -= elements;
    }

    const tinygltf::Model& model_;
    const File& file_;
    std::uint64_t elementsLeft_;
    std::map<std::pair<std::uint64_t, double>, MaskUse> uses_;  // by image and threshold
};

}  // namespace

const Material* materialOf(const File& file, const tinygltf::Primitive& primitive) {
    if (primitive.material < -1)
        base::refuse(fmt::format("expected a material of at least 0, found {}", primitive.material));
    const auto number = static_cast<std::size_t>(primitive.material);
    return primitive.material == -1 || number >= file.materials.size() ? nullptr : &file.materials[number];
}

std::vector<std::uint32_t> cornersOf(const tinygltf::Model& model, const File& file,
                                     const tinygltf::Primitive& primitive, std::size_t vertexCount) {
    const bool restarts = file.primitiveRestart && isContinued(Mode{primitive.mode});
    if (primitive.indices != -1)
        return readIndices(model, primitive.indices, vertexCount, restarts ? Restarts::Read : Restarts::Refused);
    std::vector<std::uint32_t> corners(vertexCount);
    std::iota(corners.begin(), corners.end(), 0U);
    return corners;
}

std::vector<double> vertexOpacities(const tinygltf::Model& model, const tinygltf::Primitive& primitive,
                                    std::size_t count) {
    std::vector<double> opacities;
    const auto color = primitive.attributes.find("COLOR_0");
    if (color != primitive.attributes.end() &&
        at(model.accessors, color->second, "an accessor").type == TINYGLTF_TYPE_VEC4) {
        for (const glm::dvec4& c : readAttribute<glm::dvec4>(model, primitive.attributes, "COLOR_0", anyColor, count)) {
            if (!std::isfinite(c.a))
                base::refuse(fmt::format("COLOR_0: expected finite numbers, found {} as alpha", c.a));
            opacities.push_back(c.a);
        }
    }
    opacities.resize(count, 1.0);
    return opacities;
}

bool varies(const std::vector<double>& opacities, std::span<const std::uint32_t> triangles) {
    for (std::size_t i = 0; i < triangles.size(); i += 3)
        if (opacities[triangles[i]] != opacities[triangles[i + 1]] ||
            opacities[triangles[i]] != opacities[triangles[i + 2]])
            return true;
    return false;
}

std::vector<MaskUse> maskUses(const tinygltf::Model& model, const File& file, const std::vector<DrawnNode>& nodes,
                              std::uint64_t maxElements) {
    Reader reader{model, file, maxElements};
    std::set<int> seen;
    try {
        for (const auto& [number, visible] : nodes) {
            const tinygltf::Node& node = model.nodes[number];
            if (node.mesh == -1 || !visible) continue;
            const bool isNew = seen.insert(node.mesh).second;
            const bool ownShape = node.skin != -1 || !node.weights.empty();  // is made anew for the node
            if (!isNew && !ownShape) continue;
            for (const tinygltf::Primitive& primitive : at(model.meshes, node.mesh, "a mesh").primitives)
                reader.read(primitive);
        }
    } catch (const Error&) {
        return {};
    }
    return reader.uses();
}

}  // namespace inkedge::gltf
