#include <inkedge/inspect_model.h>

#include <algorithm>
#include <utility>

#include <inkedge/setting_table.h>

#include "base/message.h"
#include "formats/reader.h"

namespace inkedge {
namespace {

bool drawsTriangles(const Scene::Data& data) {
    return std::ranges::any_of(data.instances, [&](const Instance& instance) {
        return instance.mesh >= data.meshes.size() || !data.meshes[instance.mesh].indices.empty();  // Scene checks it
    });
}

std::vector<MeshContents> meshesOf(const Scene& scene) {
    std::vector<MeshContents> all;
    for (const Mesh& mesh : scene.meshes())
        all.push_back({mesh.name, mesh.indices.size() / 3, mesh.positions.size(), 0});
    for (const Instance& instance : scene.instances()) ++all[instance.mesh].instances;
    return all;
}

}  // namespace

ModelContents inspectModel(const std::filesystem::path& file, const LoadSettings& settings) {
    validate(settings);
    const formats::ModelInput input{file};
    Scene::Data data = formats::readModel(input, settings);
    if (!drawsTriangles(data))
        return {.source = std::move(data.source),
                .meshes = {},
                .cameras = std::move(data.cameras),
                .materials = std::move(data.materials),
                .warnings = std::move(data.warnings),
                .undrawn = std::move(data.undrawn),
                .instances = 0,
                .triangles = 0,
                .box = {}};
    const Scene scene = base::within(input.where(), [&] { return Scene{std::move(data), settings}; });
    return {.source = scene.source(),
            .meshes = meshesOf(scene),
            .cameras = scene.cameras(),
            .materials = scene.materials(),
            .warnings = scene.warnings(),
            .undrawn = {},
            .instances = scene.instances().size(),
            .triangles = scene.triangleCount(),
            .box = scene.box()};
}

}  // namespace inkedge
