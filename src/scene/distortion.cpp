#include "scene/distortion.h"

#include <vector>

#include <fmt/format.h>

#include "base/message.h"
#include "mesh/distort.h"

namespace inkedge::scene {
namespace {

// Drops the meshes that no instance uses any more.
void dropUnusedMeshes(Scene::Data& data) {
    constexpr std::uint32_t dropped = ~0U;
    std::vector<std::uint32_t> renumbered(data.meshes.size(), dropped);
    for (const Instance& instance : data.instances) renumbered[instance.mesh] = 0;
    std::vector<Mesh> kept;
    for (std::size_t i = 0; i < data.meshes.size(); ++i) {
        if (renumbered[i] == dropped) continue;
        renumbered[i] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(std::move(data.meshes[i]));
    }
    data.meshes = std::move(kept);
    for (Instance& instance : data.instances) instance.mesh = renumbered[instance.mesh];
}

}  // namespace

void bakeDistortedInstances(Scene::Data& data, std::uint64_t maxElements) {
    std::uint64_t elements = 0;
    for (Instance& instance : data.instances) {
        const glm::dmat3 linear{instance.transform};
        if (mesh::keepsAngles(linear)) continue;
        const Mesh& source = data.meshes[instance.mesh];
        elements += source.positions.size() + source.indices.size() + source.lines.size();
        if (elements > maxElements)
            base::refuse(
                fmt::format("expected at most {} vertices and indices in meshes that their instances distort, "
                            "found more; raise max-vertices",
                            maxElements));
        data.meshes.push_back(mesh::distorted(data.meshes[instance.mesh], linear));
        instance.mesh = static_cast<std::uint32_t>(data.meshes.size() - 1);
        const glm::dvec4 translation = instance.transform[3];
        instance.transform = glm::dmat4{1.0};
        instance.transform[3] = translation;
    }
    dropUnusedMeshes(data);
}

}  // namespace inkedge::scene
