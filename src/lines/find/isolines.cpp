#include "lines/find/isolines.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace inkedge::lines {
namespace {

constexpr double sameShare = 1e-4;  // of an edge's length: float coordinates on two sides of a seam differ by less

// Where a line meets an edge of the mesh; or a point, which is then both ends of the edge, and the share is 0.
struct EdgePoint {
    std::uint32_t lesserPoint;
    std::uint32_t greaterPoint;
    double share;  // of the way from the lesser to the greater point
};

class IsolineFinder {
public:
    IsolineFinder(const Mesh& mesh, const mesh::MeshTopology& topology) : mesh_{mesh}, topology_{topology} {}

    std::vector<IsolineSegment> find(Isolines steps) {
        for (std::uint32_t t = 0; t < topology_.originals.size(); ++t) {
            if (topology_.originals[t] != t || collapsed(t)) continue;
            addLines(t, 0, steps.u);
            addLines(t, 1, steps.v);
        }
        dropRepeatedEdges();
        numberNodes();
        return std::move(segments_);
    }

private:
    [[nodiscard]] bool collapsed(std::uint32_t t) const {
        const std::uint32_t* const p = &topology_.points[3 * std::size_t{t}];
        return p[0] == p[1] || p[1] == p[2] || p[2] == p[0];
    }

    void addLines(std::uint32_t triangle, std::uint32_t coordinate, int steps) {
        if (steps == 0) return;
        std::array<double, 3> values{};
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec2 uv = mesh_.textureCoordinates[mesh_.indices[3 * std::size_t{triangle} + k]];
            values[k] = double{uv[static_cast<int>(coordinate)]} * steps;
        }
        const auto [low, high] = std::ranges::minmax(values);
        constexpr double largest = 2147483000.0;
        if (low == high || high - low > maxStepsPerFace || low < -largest || high > largest) return;
        for (double step = std::ceil(low); step <= high; ++step)
            addLine(triangle, coordinate, static_cast<std::int32_t>(step), values);
    }

    void addLine(std::uint32_t triangle, std::uint32_t coordinate, std::int32_t step,
                 const std::array<double, 3>& values) {
        IsolineSegment segment{triangle, coordinate, step, {}, {}, {}};
        std::array<EdgePoint, 2> ends{};
        std::size_t count = 0;
        const auto add = [&](std::uint32_t from, std::uint32_t to, double share) {
            segment.weights[count][static_cast<int>(from)] += 1.0 - share;
            segment.weights[count][static_cast<int>(to)] += share;
            ends[count++] = {pointOf(triangle, from), pointOf(triangle, to), share};
        };
        for (std::uint32_t k = 0; k < 3 && count < 2; ++k) {
            const std::uint32_t next = (k + 1) % 3;
            const double above = values[k] - step;
            const double below = values[next] - step;
            if (above == 0.0) add(k, k, 0.0);
            if (above * below >= 0.0 || count == 2) continue;
            if (pointOf(triangle, k) < pointOf(triangle, next))
                add(k, next, above / (above - below));
            else
                add(next, k, below / (below - above));
        }
        if (count < 2) return;  // the line only touches a corner
        for (std::size_t i = 0; i < 2; ++i) segment.ends[i] = positionAt(triangle, segment.weights[i]);
        segments_.push_back(segment);
        ends_.push_back(ends);
    }

    [[nodiscard]] std::uint32_t pointOf(std::uint32_t triangle, std::uint32_t corner) const {
        return topology_.points[3 * std::size_t{triangle} + corner];
    }

    [[nodiscard]] glm::dvec3 positionAt(std::uint32_t triangle, glm::dvec3 weights) const {
        glm::dvec3 sum{0.0};
        for (std::uint32_t k = 0; k < 3; ++k)
            sum += weights[static_cast<int>(k)] *
                   glm::dvec3{mesh_.positions[mesh_.indices[3 * std::size_t{triangle} + k]]};
        return sum;
    }

    // A line along an edge is found in each face of the edge: only the first one is kept.
    void dropRepeatedEdges() {
        struct Along {
            std::uint32_t lesserPoint;
            std::uint32_t greaterPoint;
            std::uint32_t coordinate;
            std::uint32_t segment;
        };
        std::vector<Along> along;
        for (std::uint32_t i = 0; i < segments_.size(); ++i) {
            const auto& [a, b] = ends_[i];
            if (a.lesserPoint != a.greaterPoint || b.lesserPoint != b.greaterPoint) continue;
            const auto [lesser, greater] = std::minmax(a.lesserPoint, b.lesserPoint);
            along.push_back({lesser, greater, segments_[i].coordinate, i});
        }
        const auto key = [](const Along& a) { return std::tuple{a.lesserPoint, a.greaterPoint, a.coordinate}; };
        std::ranges::stable_sort(along, {}, key);
        std::vector<bool> repeated(segments_.size());
        for (std::size_t i = 1; i < along.size(); ++i)
            if (key(along[i]) == key(along[i - 1])) repeated[along[i].segment] = true;
        std::size_t kept = 0;
        for (std::size_t i = 0; i < segments_.size(); ++i) {
            if (repeated[i]) continue;
            segments_[kept] = segments_[i];
            ends_[kept++] = ends_[i];
        }
        segments_.resize(kept);
        ends_.resize(kept);
    }

    void numberNodes() {
        std::vector<std::uint32_t> order(2 * segments_.size());
        std::iota(order.begin(), order.end(), 0U);
        const auto edgePoint = [&](std::uint32_t end) { return ends_[end / 2][end % 2]; };
        const auto key = [&](std::uint32_t end) {
            const IsolineSegment& segment = segments_[end / 2];
            return std::tuple{segment.coordinate, segment.step, edgePoint(end).lesserPoint,
                              edgePoint(end).greaterPoint};
        };
        std::ranges::sort(order, [&](std::uint32_t x, std::uint32_t y) {
            return std::tuple{key(x), edgePoint(x).share, x} < std::tuple{key(y), edgePoint(y).share, y};
        });
        std::uint32_t node = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            const bool isNew = i > 0 && (key(order[i]) != key(order[i - 1]) ||
                                         edgePoint(order[i]).share - edgePoint(order[i - 1]).share > sameShare);
            if (isNew) ++node;
            segments_[order[i] / 2].nodes[order[i] % 2] = node;
        }
    }

    const Mesh& mesh_;
    const mesh::MeshTopology& topology_;
    std::vector<IsolineSegment> segments_;
    std::vector<std::array<EdgePoint, 2>> ends_;  // one pair per segment: its ends
};

}  // namespace

std::vector<IsolineSegment> findIsolines(const Mesh& mesh, const mesh::MeshTopology& topology, Isolines steps) {
    if (mesh.textureCoordinates.empty()) return {};
    return IsolineFinder{mesh, topology}.find(steps);
}

}  // namespace inkedge::lines
