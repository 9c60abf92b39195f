#include "mesh/opaque_part.h"

#include <algorithm>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "base/message.h"
#include "mesh/polygon_triangles.h"
#include "mesh/simplify_loop.h"

namespace inkedge::mesh {
namespace {

constexpr double simplification = 0.2;  // steps
constexpr std::size_t maxCorners = std::size_t{1} << 20U;

using Index = std::uint64_t;

// A point of the triangle's lattice, with its excess. (0, 0), (n, 0) and (0, n) are the corners.
struct Sample {
    Index i = 0;
    Index j = 0;
    double excess = 0.0;

    [[nodiscard]] bool inside() const { return excess >= 0.0; }
    [[nodiscard]] glm::dvec2 point() const { return {static_cast<double>(i), static_cast<double>(j)}; }
};

// A corner of the outline. Each but those of the triangle lies on an edge of the lattice: from its lowest point along
// i, along j, or from the point after it along i to the one after it along j.
struct Corner {
    Index key = 0;
    glm::dvec2 point{0.0};
    bool fixed = false;  // on the triangle's border, where the triangle beyond has the same corner
};

// The outline of a triangle's opaque part: marching triangles, which unlike squares know no saddle.
class Outline {
public:
    Outline(const EdgeSteps& steps, const Excess& excess)
        : n_{std::max({steps[0], steps[1], steps[2]})}, excess_{excess} {
        for (std::size_t edge = 0; edge < 3; ++edge) border_[edge] = edgeSamples(edge, steps[edge]);
    }

    std::vector<Polygon> trace() {
        std::vector<Sample> lower = row(0);
        for (Index j = 0; j < n_; ++j) {
            const std::vector<Sample> upper = row(j + 1);
            for (Index i = 0; i + j < n_; ++i) {
                traceTriangle(lower[i], lower[i + 1], upper[i]);
                if (i + j + 1 < n_) traceTriangle(lower[i + 1], upper[i + 1], upper[i]);
            }
            lower = upper;
        }
        traceBorder();
        return takeLoops();
    }

private:
    // The k-th point of an edge, counted from its first corner.
    [[nodiscard]] Sample onEdge(std::size_t edge, Index k) const {
        if (edge == 0) return {k, 0};
        return edge == 1 ? Sample{n_ - k, k} : Sample{0, n_ - k};
    }

    [[nodiscard]] double excessAt(const Sample& at) const {
        const auto n = static_cast<double>(n_);
        return excess_(
            {static_cast<double>(n_ - at.i - at.j) / n, static_cast<double>(at.i) / n, static_cast<double>(at.j) / n});
    }

    // All points of an edge; those between its own steps lie on a straight line between these.
    [[nodiscard]] std::vector<Sample> edgeSamples(std::size_t edge, Index steps) const {
        const Index stride = n_ / steps;
        std::vector<Sample> samples(n_ + 1);
        for (Index k = 0; k <= n_; k += stride) {
            samples[k] = onEdge(edge, k);
            samples[k].excess = excessAt(samples[k]);
            for (Index between = 1; k > 0 && between < stride; ++between) {
                Sample& sample = samples[k - stride + between];
                sample = onEdge(edge, k - stride + between);
                sample.excess = glm::mix(samples[k - stride].excess, samples[k].excess,
                                         static_cast<double>(between) / static_cast<double>(stride));
            }
        }
        return samples;
    }

    [[nodiscard]] std::vector<Sample> row(Index j) const {
        if (j == 0) return border_[0];
        std::vector<Sample> samples(n_ - j + 1);
        for (Index i = 1; i + j < n_; ++i) {
            samples[i] = {i, j};
            samples[i].excess = excessAt(samples[i]);
        }
        samples.front() = border_[2][n_ - j];
        samples.back() = border_[1][j];
        return samples;
    }

    [[nodiscard]] Index keyOf(Index i, Index j, Index kind) const { return 4 * (j * (n_ + 1) + i) + kind; }

    // Where the outline crosses the edge of the lattice between two points.
    [[nodiscard]] Corner crossing(const Sample& in, const Sample& out) const {
        const Index kind = in.j == out.j ? 0 : in.i == out.i ? 1 : 2;
        const bool border = in.i + out.i == 0 || in.j + out.j == 0 || (in.i + in.j == n_ && out.i + out.j == n_);
        const double share = in.excess / (in.excess - out.excess);
        return {keyOf(std::min(in.i, out.i), std::min(in.j, out.j), kind), glm::mix(in.point(), out.point(), share),
                border};
    }

    void link(const Corner& from, const Corner& to) {
        if (next_.size() >= maxCorners)
            base::refuse(
                fmt::format("expected an outline of at most {} corners in a triangle, found more", maxCorners));
        next_.emplace(from.key, std::pair{from, to.key});
    }

    // Three points, anticlockwise; the inside lies to the left of the outline.
    void traceTriangle(const Sample& a, const Sample& b, const Sample& c) {
        if (a.inside() == b.inside() && b.inside() == c.inside()) return;
        const std::array corners{a, b, c};
        Corner from;
        Corner to;
        for (std::size_t k = 0; k < 3; ++k) {
            const Sample& here = corners[k];
            const Sample& after = corners[(k + 1) % 3];
            if (here.inside() && !after.inside()) from = crossing(here, after);
            if (!here.inside() && after.inside()) to = crossing(after, here);
        }
        link(from, to);
    }

    // Along the triangle's border, anticlockwise.
    void traceBorder() {
        Corner from = cornerOf(border_[0][0]);
        for (const std::vector<Sample>& edge : border_) {
            for (Index k = 0; k < n_; ++k) {
                const Sample& here = edge[k];
                const Sample& after = edge[k + 1];
                if (here.inside() && !after.inside()) link(from, crossing(here, after));
                if (!here.inside() && after.inside()) from = crossing(after, here);
            }
            if (!edge.back().inside()) continue;
            const Corner corner = cornerOf(edge.back());
            link(from, corner);
            from = corner;
        }
    }
    [[nodiscard]] Corner cornerOf(const Sample& at) const { return {keyOf(at.i, at.j, 3), at.point(), true}; }

    [[nodiscard]] std::vector<Polygon> takeLoops() {
        std::vector<Polygon> loops;
        while (!next_.empty()) {
            Polygon loop;
            std::vector<bool> fixed;
            for (auto link = next_.begin(); link != next_.end();) {
                const auto [corner, to] = link->second;
                loop.push_back(corner.point);
                fixed.push_back(corner.fixed);
                next_.erase(link);
                link = next_.find(to);
            }
            loops.push_back(simplified(loop, fixed, simplification));
        }
        return loops;
    }

    Index n_;
    const Excess& excess_;
    std::array<std::vector<Sample>, 3> border_;
    std::unordered_map<Index, std::pair<Corner, Index>> next_;  // by key: a corner, and the next one's key
};

}  // namespace

std::vector<TrianglePiece> opaquePart(const EdgeSteps& steps, const Excess& excess) {
    const double n = std::max({steps[0], steps[1], steps[2]});
    const std::vector<Polygon> loops = Outline{steps, excess}.trace();
    std::vector<PolygonTriangle> triangles;
    if (loops.size() == 1 && loops.front().size() <= 4 && n == 1.0)
        triangles = convexTriangles(loops.front());
    else if (!loops.empty())
        triangles = trianglesWithin({{-n, -n}, {3 * n, -n}, {-n, 3 * n}}, untangled(loops));
    std::vector<TrianglePiece> pieces;
    const auto weights = [&](const glm::dvec2& p) {
        return glm::clamp(glm::dvec3{(n - p.x - p.y) / n, p.x / n, p.y / n}, 0.0, 1.0);
    };
    for (const PolygonTriangle& t : triangles) pieces.push_back({weights(t[0]), weights(t[1]), weights(t[2])});
    return pieces;
}

}  // namespace inkedge::mesh
