#include "trace/components.h"

#include "mesh/topology.h"
#include "scene/prepared.h"

namespace inkedge::trace {
namespace {

// Faces of one patch are connected: only creases lead to another.
base::UnionFind patchesAcrossCreases(const mesh::MeshTopology& topology) {
    base::UnionFind patches{topology.patchCount()};
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (topology.creases[h] && mesh::isHalfEdge(twin))
            patches.unite(topology.patches[h / 3], topology.patches[twin / 3]);
    }
    return patches;
}

}  // namespace

bool Components::connect(scene::SceneFace a, scene::SceneFace b) {
    if (a.instance != b.instance) return false;
    const std::uint32_t meshIndex = scene_.instances()[a.instance].mesh;
    const mesh::MeshTopology& topology = scene::topologyOf(scene_, meshIndex);
    const std::uint32_t patchA = topology.patches[a.triangle];
    const std::uint32_t patchB = topology.patches[b.triangle];
    if (patchA == patchB) return true;
    std::optional<base::UnionFind>& patches = patches_[meshIndex];
    if (!patches) patches = patchesAcrossCreases(topology);
    return patches->root(patchA) == patches->root(patchB);
}

}  // namespace inkedge::trace
