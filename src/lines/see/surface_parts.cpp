#include "lines/see/surface_parts.h"

#include <algorithm>

#include "base/union_find.h"
#include "mesh/topology.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

struct MeshParts {
    std::vector<std::uint32_t> ofFaces;  // 0..count-1
    std::uint32_t count = 0;
};

MeshParts partsOf(const MeshTopology& topology) {
    const auto faces = static_cast<std::uint32_t>(topology.originals.size());
    UnionFind whole{faces};
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (isHalfEdge(twin) && h < twin) whole.unite(h / 3, twin / 3);
    }
    MeshParts parts;
    parts.ofFaces.resize(faces);
    for (std::uint32_t t = 0; t < faces; ++t) {  // a root comes before all others of its part
        const std::uint32_t root = whole.root(t);
        parts.ofFaces[t] = root == t ? parts.count++ : parts.ofFaces[root];
    }
    return parts;
}

}  // namespace

SurfaceParts::SurfaceParts(const Scene& scene, std::span<const BorderPart> borders) {
    std::vector<std::uint32_t> counts;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
        MeshParts parts = partsOf(topologyOf(scene, i));
        ofFaces_.push_back(std::move(parts.ofFaces));
        counts.push_back(parts.count);
    }
    std::uint32_t total = 0;
    for (const Instance& instance : scene.instances()) {
        meshes_.push_back(instance.mesh);
        begins_.push_back(total);
        total += counts[instance.mesh];
    }
    UnionFind joined{total};
    const auto number = [&](SceneFace face) {
        return begins_[face.instance] + ofFaces_[meshes_[face.instance]][face.triangle];
    };
    for (const BorderPart& border : borders)
        if (border.other != noFace) joined.unite(number({border.instance, border.halfEdge / 3}), number(border.other));
    parts_.resize(total);
    for (std::uint32_t i = 0; i < total; ++i) parts_[i] = joined.root(i);
    areOne_ = std::ranges::all_of(parts_, [](std::uint32_t part) { return part == 0; });
}

}  // namespace inkedge::lines
