#include "scene/patch_numbers.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "scene/coplanar_layers.h"
#include "scene/seams.h"
#include "mesh/topology.h"
#include "base/union_find.h"

namespace inkedge {

PatchNumbers numberPatches(const Scene& scene, double creaseAngle) {
    PatchNumbers patches;
    std::uint32_t total = 0;
    for (const Instance& instance : scene.instances()) {
        patches.base.push_back(total);
        total += scene.topology(instance.mesh).patchCount;
    }
    UnionFind joined{total};
    joinAcrossSeams(scene, patches.base, creaseAngle, joined);
    patches.number.resize(total);
    for (std::uint32_t p = 0; p < total; ++p) {  // a root is the least of its set, so it comes first
        const std::uint32_t root = joined.root(p);
        patches.number[p] = root == p ? ++patches.count : patches.number[root];
    }
    patches.layered = findCoplanarLayers(scene, patches);
    return patches;
}

}  // namespace inkedge
