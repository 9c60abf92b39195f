#include "scene/distortion.h"

#include <vector>

#include <fmt/format.h>

#include "base/message.h"
#include "mesh/distort.h"
#include "scene/choose_nodes.h"

namespace inkedge::scene {

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
