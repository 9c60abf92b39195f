#include <inkedge/inspect_model.h>

#include <algorithm>
#include <utility>

#include <glm/geometric.hpp>

#include <inkedge/setting_table.h>

#include "base/message.h"
#include "formats/reader.h"

namespace inkedge {
namespace {

bool drawsAnything(const Scene::Data& data) {
    return std::ranges::any_of(data.instances, [&](const Instance& instance) {
        if (instance.mesh >= data.meshes.size()) return true;  // Scene checks it
        const Mesh& mesh = data.meshes[instance.mesh];
        return !mesh.indices.empty() || !mesh.lines.empty();
    });
}

std::vector<MeshContents> meshesOf(const Scene& scene) {
    std::vector<MeshContents> all;
    for (const Mesh& mesh : scene.meshes())
        all.push_back({mesh.name, mesh.indices.size() / 3, mesh.lines.size() / 2, mesh.positions.size(), 0});
    for (const Instance& instance : scene.instances()) ++all[instance.mesh].instances;
    return all;
}

ModelContents inspect(const formats::ModelInput& input, const LoadSettings& settings) {
    validate(settings);
    Scene::Data data = formats::readModel(input, settings);
    const glm::dvec3 up = glm::normalize(settings.up.value_or(data.source.up));
    if (!drawsAnything(data))
        return {.source = std::move(data.source),
                .meshes = {},
                .cameras = std::move(data.cameras),
                .materials = std::move(data.materials),
                .warnings = std::move(data.warnings),
                .undrawn = std::move(data.undrawn),
                .instances = {},
                .triangles = 0,
                .lines = 0,
                .up = up,
                .box = {}};
    const Scene scene = base::within(input.where(), [&] { return Scene{std::move(data), settings}; });
    std::vector<MeshContents> meshes = meshesOf(scene);
    std::uint64_t lines = 0;
    for (const MeshContents& mesh : meshes) lines += mesh.instances * mesh.lines;
    return {.source = scene.source(),
            .meshes = std::move(meshes),
            .cameras = scene.cameras(),
            .materials = scene.materials(),
            .warnings = scene.warnings(),
            .undrawn = {},
            .instances = namesOf(scene).instances,
            .triangles = scene.triangleCount(),
            .lines = lines,
            .up = up,
            .box = scene.box()};
}

}  // namespace

ModelContents inspectModel(const std::filesystem::path& file, const LoadSettings& settings) {
    return inspect({file}, settings);
}

ModelContents inspectModel(std::span<const std::uint8_t> bytes, const std::filesystem::path& name,
                           const LoadSettings& settings) {
    return inspect({name, bytes}, settings);
}

}  // namespace inkedge
