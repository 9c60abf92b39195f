#include "lines/find/traced_form.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/union_find.h"

namespace inkedge::lines {
namespace {

// Moves the end that is under 0 to where the value is 0. False: both ends are.
bool cutAtZero(FormSegment& segment, std::array<double, 2> values) {
    if (values[0] < 0.0 && values[1] < 0.0) return false;
    for (std::size_t k = 0; k < 2; ++k) {
        if (values[k] >= 0.0) continue;
        const double share = values[k] / (values[k] - values[1 - k]);
        segment.ends[k] = glm::mix(segment.ends[k], segment.ends[1 - k], share);
        segment.strengths[k] = glm::mix(segment.strengths[k], segment.strengths[1 - k], share);
        segment.edges[k] = mesh::noHalfEdge;
    }
    return true;
}

}  // namespace

void traceThrough(const FormFace& face, const std::array<FormCorner, 3>& corners, double minStrength,
                  std::vector<FormSegment>& to) {
    FormSegment segment{face.triangle, {}, {}, {}};
    std::array<double, 2> facing{};
    std::size_t found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        const FormCorner& a = corners[k];
        const FormCorner& b = corners[next];
        if ((a.value > 0.0) == (b.value > 0.0)) continue;
        const double share = a.value / (a.value - b.value);
        segment.ends[found] = glm::mix(face.positions[k], face.positions[next], share);
        segment.strengths[found] = glm::mix(a.strength, b.strength, share);
        segment.edges[found] = face.edges[k];
        facing[found++] = glm::mix(a.facing, b.facing, share);
    }
    if (found < 2 || (facing[0] <= 0.0 && facing[1] <= 0.0)) return;
    if (facing[0] < 0.0 || facing[1] < 0.0) {
        const std::array<double, 2> before = segment.strengths;
        if (!cutAtZero(segment, facing)) return;
        segment.strengths = {std::max(segment.strengths[0], std::min(before[0], before[1])),
                             std::max(segment.strengths[1], std::min(before[0], before[1]))};
    }
    if (!cutAtZero(segment, {segment.strengths[0] - minStrength, segment.strengths[1] - minStrength})) return;
    to.push_back(segment);
}

std::vector<FormSegment> strongLines(std::vector<FormSegment> segments, double threshold,
                                     std::span<const double> minLengths, const mesh::MeshTopology& topology) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> meetings;  // edges and segments that end there
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
        for (const std::uint32_t edge : segments[s].edges)
            if (edge != mesh::noHalfEdge) meetings.emplace_back(edge, s);
    }
    std::ranges::sort(meetings);
    base::UnionFind lines{static_cast<std::uint32_t>(segments.size())};
    for (std::size_t i = 1; i < meetings.size(); ++i)
        if (meetings[i].first == meetings[i - 1].first) lines.unite(meetings[i].second, meetings[i - 1].second);
    std::vector<double> lengths(segments.size(), 0.0);
    std::vector<double> strengths(segments.size(), 0.0);
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
        const std::uint32_t line = lines.root(s);
        lengths[line] += glm::distance(segments[s].ends[0], segments[s].ends[1]);
        strengths[line] = std::max({strengths[line], segments[s].strengths[0], segments[s].strengths[1]});
    }
    std::vector<FormSegment> kept;
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
        const std::uint32_t line = lines.root(s);
        if (strengths[line] >= threshold && lengths[line] >= minLengths[topology.patches[segments[s].triangle]])
            kept.push_back(segments[s]);
    }
    return kept;
}

}  // namespace inkedge::lines
