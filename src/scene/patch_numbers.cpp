#include "scene/patch_numbers.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/union_find.h"
#include "mesh/topology.h"
#include "scene/coplanar_layers.h"
#include "scene/seams.h"

namespace inkedge::scene {

PatchNumbers numberPatches(const InstancedMeshes& instanced, const LoadSettings& settings) {
    PatchNumbers patches;
    std::uint32_t total = 0;
    for (std::size_t i = 0; i < instanced.instances.size(); ++i) {
        patches.base.push_back(total);
        total += instanced.topologyOf(i).patchCount();
    }
    base::UnionFind joined{total};
    for (std::size_t i = 0; i < instanced.instances.size(); ++i) {
        const std::vector<std::uint32_t>& surfaces = instanced.topologyOf(i).surfaces;
        for (std::uint32_t p = 0; p < surfaces.size(); ++p)
            joined.unite(patches.base[i] + p, patches.base[i] + surfaces[p]);
    }
    joinAcrossSeams(instanced, patches.base, settings, joined);
    patches.number.resize(total);
    for (std::uint32_t p = 0; p < total; ++p) {  // a set's root is its smallest member, so it comes first
        const std::uint32_t root = joined.root(p);
        patches.number[p] = root == p ? ++patches.count : patches.number[root];
    }
    patches.layered = findCoplanarLayers(instanced, patches);
    return patches;
}

}  // namespace inkedge::scene
