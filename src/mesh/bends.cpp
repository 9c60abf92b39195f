#include "mesh/bends.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace inkedge::mesh {

std::size_t strideOf(std::size_t halfEdges, std::size_t wanted) noexcept {
    const std::size_t stride = halfEdges / wanted + 1;
    return stride % 3 == 0 ? stride + 1 : stride;  // else one side only of every triangle
}

double medianOf(std::vector<EdgeBend> edges, double otherwise) {
    std::ranges::sort(edges, {}, &EdgeBend::bend);
    double sum = 0.0;
    for (const EdgeBend& edge : edges) sum += edge.length;
    double before = 0.0;
    for (const EdgeBend& edge : edges) {
        before += edge.length;
        if (before >= 0.5 * sum) return edge.bend;
    }
    return otherwise;
}

double medianBend(const Mesh& mesh, const MeshTopology& topology) {
    constexpr std::size_t maxSamples = 1U << 16U;
    const std::size_t stride = strideOf(topology.twins.size(), maxSamples);
    std::vector<EdgeBend> edges;
    for (std::size_t i = 0; i < topology.twins.size(); i += stride) {
        const auto h = static_cast<std::uint32_t>(i);
        const std::uint32_t twin = topology.twins[h];
        if (!isHalfEdge(twin) || !hasNormal(topology, h / 3) || !hasNormal(topology, twin / 3)) continue;
        if (isInner(mesh, h, twin)) continue;
        const double bend = glm::degrees(std::acos(std::clamp(bendCosine(topology, h, twin), -1.0, 1.0)));
        const float length =
            glm::distance(mesh.positions[mesh.indices[h]], mesh.positions[mesh.indices[nextHalfEdge(h)]]);
        edges.push_back({bend, static_cast<double>(length)});
    }
    return medianOf(std::move(edges), 0.0);
}

}  // namespace inkedge::mesh
