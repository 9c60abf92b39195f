#include "mesh/roughness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace inkedge::mesh {

double medianBend(const Mesh& mesh, const MeshTopology& topology) {
    constexpr std::size_t maxSamples = 1U << 16U;
    std::array<double, 181> lengths{};  // by the bend, rounded down
    std::size_t stride = topology.twins.size() / maxSamples + 1;
    if (stride % 3 == 0) ++stride;  // else one side only of every triangle
    for (std::size_t i = 0; i < topology.twins.size(); i += stride) {
        const auto h = static_cast<std::uint32_t>(i);
        const std::uint32_t twin = topology.twins[h];
        if (!isHalfEdge(twin) || !hasNormal(topology, h / 3) || !hasNormal(topology, twin / 3)) continue;
        if (isInner(mesh, h, twin)) continue;
        const double bend = glm::degrees(std::acos(std::clamp(bendCosine(topology, h, twin), -1.0, 1.0)));
        lengths[static_cast<std::size_t>(bend)] += static_cast<double>(
            glm::distance(mesh.positions[mesh.indices[h]], mesh.positions[mesh.indices[nextHalfEdge(h)]]));
    }
    const double all = std::accumulate(lengths.begin(), lengths.end(), 0.0);
    double before = 0.0;
    for (std::size_t bend = 0; bend < lengths.size(); ++bend) {
        before += lengths[bend];
        if (before > 0.5 * all) return static_cast<double>(bend);
    }
    return 0.0;
}

}  // namespace inkedge::mesh
