#include "lines/see/surface_components.h"

#include <algorithm>

#include "base/union_find.h"
#include "mesh/topology.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

struct MeshComponents {
    std::vector<std::uint32_t> ofFaces;  // 0..count-1
    std::uint32_t count = 0;
};

MeshComponents componentsOf(const mesh::MeshTopology& topology) {
    const auto faces = static_cast<std::uint32_t>(topology.originals.size());
    base::UnionFind whole{faces};
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (mesh::isHalfEdge(twin) && h < twin) whole.unite(h / 3, twin / 3);
    }
    MeshComponents components;
    components.ofFaces.resize(faces);
    for (std::uint32_t t = 0; t < faces; ++t) {  // a root is the first member of its component
        const std::uint32_t root = whole.root(t);
        components.ofFaces[t] = root == t ? components.count++ : components.ofFaces[root];
    }
    return components;
}

}  // namespace

SurfaceComponents::SurfaceComponents(const Scene& scene, std::span<const BorderSegment> borders) {
    std::vector<std::uint32_t> counts;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
        MeshComponents components = componentsOf(scene::topologyOf(scene, i));
        ofFaces_.push_back(std::move(components.ofFaces));
        counts.push_back(components.count);
    }
    std::uint32_t total = 0;
    for (const Instance& instance : scene.instances()) {
        meshes_.push_back(instance.mesh);
        begins_.push_back(total);
        total += counts[instance.mesh];
    }
    base::UnionFind joined{total};
    const auto number = [&](scene::SceneFace face) {
        return begins_[face.instance] + ofFaces_[meshes_[face.instance]][face.triangle];
    };
    for (const BorderSegment& border : borders)
        if (border.other != noFace) joined.unite(number({border.instance, border.halfEdge / 3}), number(border.other));
    components_.resize(total);
    for (std::uint32_t i = 0; i < total; ++i) components_[i] = joined.root(i);
    areOne_ = std::ranges::all_of(components_, [](std::uint32_t component) { return component == 0; });
}

}  // namespace inkedge::lines
