#include "lines/see/crossings.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "base/stop.h"

namespace inkedge::lines {
namespace {

constexpr double cellSize = 8.0;  // pixels
constexpr double minStep = 0.05;  // footprints: an occluder that is nearer by less lies on the same surface

constexpr std::uint32_t segmentsBetweenLooks = 256;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

class Grid {
public:
    explicit Grid(Size size)
        : columns_{static_cast<int>(std::ceil(size.width / cellSize))},
          rows_{static_cast<int>(std::ceil(size.height / cellSize))} {}

    // Calls visit(cell) for each cell that a segment touches, and perhaps for a few cells beside it.
    template <class Visit>
    void forEachCell(const ScreenSegment& s, Visit&& visit) const {
        const glm::dvec2 a = s.ends[0].pixel / cellSize;
        const glm::dvec2 b = s.ends[1].pixel / cellSize;
        const auto clampRow = [&](double y) {
            return std::clamp(static_cast<int>(std::clamp(std::floor(y), -1.0, 1e9)), 0, rows_ - 1);
        };
        const auto clampColumn = [&](double x) {
            return std::clamp(static_cast<int>(std::clamp(std::floor(x), -1.0, 1e9)), 0, columns_ - 1);
        };
        const int firstRow = clampRow(std::min(a.y, b.y));
        const int lastRow = clampRow(std::max(a.y, b.y));
        for (int row = firstRow; row <= lastRow; ++row) {
            double low = std::min(a.x, b.x);
            double high = std::max(a.x, b.x);
            if (firstRow != lastRow && a.y != b.y) {  // the part of the segment between the row's borders
                const auto at = [&](double y) {
                    return a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
                };
                const double top = at(row == firstRow ? std::min(a.y, b.y) : row);
                const double bottom = at(row == lastRow ? std::max(a.y, b.y) : row + 1);
                low = std::min(top, bottom);
                high = std::max(top, bottom);
            }
            const int last = clampColumn(high);
            for (int column = clampColumn(low); column <= last; ++column)
                visit(static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(column));
        }
    }

    [[nodiscard]] std::size_t cellOf(glm::dvec2 pixel) const {
        const int column = std::clamp(static_cast<int>(std::floor(pixel.x / cellSize)), 0, columns_ - 1);
        const int row = std::clamp(static_cast<int>(std::floor(pixel.y / cellSize)), 0, rows_ - 1);
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    [[nodiscard]] std::size_t cells() const {
        return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    }

private:
    int columns_;
    int rows_;
};

bool meet(const Segment& a, const Segment& b) {
    for (const Key ka : a.keys)
        for (const Key kb : b.keys)
            if (ka == kb && ka != noKey) return true;
    return false;
}

double footprints(double length, const ScreenSegment& s, const Screen& screen) {
    return length == 0.0 ? 0.0 : length / screen.footprint(s.world[0]);
}

}  // namespace

std::vector<Crossing> findCrossings(std::span<const Segment> segments, std::span<const ScreenSegment> screenSegments,
                                    const Screen& screen, const SurfaceComponents* components) {
    const Grid grid{screen.size()};
    // The occluders of each cell: first counted, then filled in.
    std::vector<std::uint32_t> begins(grid.cells() + 1, 0);
    for (std::size_t s = 0; s < segments.size(); ++s)
        if (segments[s].occludes) grid.forEachCell(screenSegments[s], [&](std::size_t cell) { ++begins[cell + 1]; });
    for (std::size_t cell = 0; cell < grid.cells(); ++cell) begins[cell + 1] += begins[cell];
    std::vector<std::uint32_t> occluders(begins.back());
    std::vector<std::uint32_t> fill(begins.begin(), begins.end() - 1);
    for (std::uint32_t s = 0; s < segments.size(); ++s)
        if (segments[s].occludes)
            grid.forEachCell(screenSegments[s], [&](std::size_t cell) { occluders[fill[cell]++] = s; });

    std::vector<Crossing> crossings;
    for (std::uint32_t s = 0; s < segments.size(); ++s) {
        if (s % segmentsBetweenLooks == 0) base::stopIfAsked();
        if (!segments[s].drawn) continue;
        const ScreenSegment& own = screenSegments[s];
        const glm::dvec2 along = own.ends[1].pixel - own.ends[0].pixel;
        const Slack slack = slackOf(segments[s], footprints(segments[s].slack, own, screen), components);
        const std::size_t before = crossings.size();
        grid.forEachCell(own, [&](std::size_t cell) {
            for (std::uint32_t i = begins[cell]; i < begins[cell + 1]; ++i) {
                const ScreenSegment& other = screenSegments[occluders[i]];
                const glm::dvec2 step = other.ends[1].pixel - other.ends[0].pixel;
                const glm::dvec2 between = other.ends[0].pixel - own.ends[0].pixel;
                const double area = cross(along, step);
                const double u = cross(between, step) / area;
                const double v = cross(between, along) / area;
                if (!(u > 0.0 && u < 1.0 && v >= 0.0 && v <= 1.0)) continue;
                if (grid.cellOf(own.ends[0].pixel + u * along) != cell) continue;  // each crossing once
                const double ownInverseDepth =
                    own.ends[0].inverseDepth + u * (own.ends[1].inverseDepth - own.ends[0].inverseDepth);
                const double otherInverseDepth =
                    other.ends[0].inverseDepth + v * (other.ends[1].inverseDepth - other.ends[0].inverseDepth);
                if (screen.footprintsBefore(otherInverseDepth, ownInverseDepth) <=
                    minStep + slack.of(segments[occluders[i]].faces[0]))
                    continue;
                if (!meet(segments[s], segments[occluders[i]])) crossings.push_back({s, u});
            }
        });
        std::sort(crossings.begin() + static_cast<std::ptrdiff_t>(before), crossings.end(),
                  [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
    }
    return crossings;
}

}  // namespace inkedge::lines
