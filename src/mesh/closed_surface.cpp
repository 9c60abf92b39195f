#include "mesh/closed_surface.h"

#include <glm/geometric.hpp>

#include "base/union_find.h"

namespace inkedge::mesh {
namespace {

bool isCollapsed(const MeshTopology& topology, std::uint32_t t) {
    const std::uint32_t* const p = &topology.points[3 * std::size_t{t}];
    return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
}

// Whether the edge of a half-edge has exactly one other face, wound alike.
bool isOpposed(const MeshTopology& topology, std::uint32_t h) {
    const std::uint32_t twin = topology.twins[h];
    return isHalfEdge(twin) && topology.points[h] != topology.points[twin];
}

// 6 times the volume of the tetrahedron between a face and the mesh's origin.
double signedVolume(const Mesh& mesh, std::uint32_t t) {
    const auto corner = [&](std::uint32_t k) {
        return glm::dvec3{mesh.positions[mesh.indices[3 * std::size_t{t} + k]]};
    };
    return glm::dot(corner(0), glm::cross(corner(1), corner(2)));
}

}  // namespace

Components findComponents(const MeshTopology& topology) {
    const auto faces = static_cast<std::uint32_t>(topology.originals.size());
    const bool hasPatches = !topology.patches.empty();
    const std::uint32_t parts = hasPatches ? topology.patchCount() : faces;
    const auto partOf = [&](std::uint32_t t) { return hasPatches ? topology.patches[t] : t; };
    base::UnionFind joined{parts};
    for (std::uint32_t h = 0; parts > 1 && h < topology.twins.size(); ++h) {
        const std::uint32_t twin = topology.twins[h];
        if (isHalfEdge(twin) && h < twin && partOf(h / 3) != partOf(twin / 3))
            joined.unite(partOf(h / 3), partOf(twin / 3));
    }
    Components components;
    components.ofFaces.resize(faces);
    constexpr std::uint32_t none = ~0U;
    std::vector<std::uint32_t> numbers(parts, none);
    for (std::uint32_t t = 0; t < faces; ++t) {
        std::uint32_t& number = numbers[joined.root(partOf(t))];
        if (number == none) number = components.count++;
        components.ofFaces[t] = number;
    }
    return components;
}

std::vector<std::int8_t> componentOrientations(const Mesh& mesh, const MeshTopology& topology) {
    const Components components = findComponents(topology);
    const auto count = static_cast<std::uint32_t>(topology.originals.size());
    const auto takesPart = [&](std::uint32_t t) { return topology.originals[t] == t && !isCollapsed(topology, t); };
    std::vector<bool> open(components.count, false);
    std::vector<double> volumes(components.count, 0.0);
    for (std::uint32_t t = 0; t < count; ++t) {
        const std::uint32_t component = components.ofFaces[t];
        if (open[component] || !takesPart(t)) continue;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
            if (!isOpposed(topology, h)) open[component] = true;
        volumes[component] += signedVolume(mesh, t);
    }
    std::vector<std::int8_t> closed(count, 0);
    for (std::uint32_t t = 0; t < count; ++t) {
        const std::uint32_t component = components.ofFaces[t];
        if (open[component] || volumes[component] == 0.0 || !takesPart(t)) continue;
        closed[t] = volumes[component] > 0.0 ? 1 : -1;
    }
    return closed;
}

bool isClosedOutward(const Mesh& mesh, const MeshTopology& topology) {
    const auto count = static_cast<std::uint32_t>(topology.originals.size());
    for (std::uint32_t t = 0; t < count; ++t) {  // most open meshes show it early
        if (isCollapsed(topology, t)) continue;
        if (topology.originals[t] != t) return false;
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h)
            if (!isOpposed(topology, h)) return false;
    }
    const std::vector<std::int8_t> closed = componentOrientations(mesh, topology);
    for (std::uint32_t t = 0; t < count; ++t)
        if (!isCollapsed(topology, t) && closed[t] != 1) return false;
    return true;
}

}  // namespace inkedge::mesh
