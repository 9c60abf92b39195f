#include "diff/samples.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge::diff {

double lengthOf(const ComparedLine& line) {
    double length = line.closed ? glm::distance(line.points.back(), line.points.front()) : 0.0;
    for (std::size_t i = 1; i < line.points.size(); ++i) length += glm::distance(line.points[i - 1], line.points[i]);
    return length;
}

namespace {

constexpr int cellsAcross = 1024;

bool leadsThrough(glm::dvec2 a, glm::dvec2 b, glm::dvec2 low, glm::dvec2 high) {
    // Separating axis across the segment; those of the rectangle hold, for it lies within the segment's bounds.
    const glm::dvec2 across{a.y - b.y, b.x - a.x};
    const glm::dvec2 middle = 0.5 * (low + high);
    const glm::dvec2 half = 0.5 * (high - low);
    return std::abs(glm::dot(across, middle - a)) <= std::abs(across.x) * half.x + std::abs(across.y) * half.y;
}

}  // namespace

SampledLines::SampledLines(std::span<const ComparedLine> lines) {
    for (std::uint32_t line = 0; line < lines.size(); ++line) {
        firstOfLine.push_back(samples.size());
        const std::vector<glm::dvec2>& points = lines[line].points;
        for (std::size_t i = 0; i + (lines[line].closed ? 0 : 1) < points.size(); ++i) {
            const glm::dvec2 a = points[i];
            const glm::dvec2 b = points[(i + 1) % points.size()];
            const double length = glm::distance(a, b);
            const auto pieces = static_cast<std::uint32_t>(std::max(1.0, std::ceil(length / sampleStep)));
            const auto segment = static_cast<std::uint32_t>(segments.size());
            segments.push_back({a, b, line, pieces, samples.size()});
            for (std::uint32_t k = 0; k < pieces; ++k)
                samples.push_back({glm::mix(a, b, (k + 0.5) / pieces), {}, length / pieces, segment});
        }
        measureDirections(firstOfLine.back(), lines[line].closed);
    }
    firstOfLine.push_back(samples.size());
}

void SampledLines::measureDirections(std::size_t first, bool closed) {
    constexpr double reach = 2.0;  // pixels
    const auto count = static_cast<std::ptrdiff_t>(samples.size() - first);
    // The sample that far from the i-th one, by steps of 1 or -1; the last one if the line ends before, and the way to
    // it.
    const auto walk = [&](std::ptrdiff_t i, std::ptrdiff_t step, double& way) {
        std::ptrdiff_t at = i;
        for (std::ptrdiff_t k = 1; k < count && way < reach; ++k) {
            std::ptrdiff_t next = i + step * k;
            if (closed) next = (next + count) % count;
            if (next < 0 || next >= count) break;
            const auto indexOf = [&](std::ptrdiff_t n) { return first + static_cast<std::size_t>(n); };
            way += glm::distance(samples[indexOf(at)].at, samples[indexOf(next)].at);
            at = next;
        }
        return samples[first + static_cast<std::size_t>(at)].at;
    };
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        double way = 0.0;
        const glm::dvec2 to = walk(i, 1, way);
        double back = 0.0;
        const glm::dvec2 from = walk(i, -1, back);
        const double chord = glm::distance(from, to);
        Sample& sample = samples[first + static_cast<std::size_t>(i)];
        if (chord > 0.5 * (way + back)) sample.along = (to - from) / chord;
    }
}

Nearest nearestOn(const Segment& segment, std::uint32_t index, glm::dvec2 point) noexcept {
    const glm::dvec2 along = segment.b - segment.a;
    const double length2 = glm::dot(along, along);
    const double share = length2 > 0.0 ? std::clamp(glm::dot(point - segment.a, along) / length2, 0.0, 1.0) : 0.0;
    const glm::dvec2 at = segment.a + share * along;
    return {index, share, at, glm::dot(point - at, point - at)};
}

SegmentGrid::SegmentGrid(std::span<const Segment> segments, Size size, double reach)
    : segments_{segments},
      reach_{reach},
      cell_{std::max({8, size.width / cellsAcross, size.height / cellsAcross})},
      columns_{size.width / cell_ + 1},
      rows_{size.height / cell_ + 1} {
    cells_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_));
    for (std::uint32_t i = 0; i < segments.size(); ++i) {
        const Segment& segment = segments[i];
        const glm::ivec2 low = cellOf(glm::min(segment.a, segment.b) - reach);
        const glm::ivec2 high = cellOf(glm::max(segment.a, segment.b) + reach);
        for (int y = low.y; y <= high.y; ++y) {
            for (int x = low.x; x <= high.x; ++x) {
                const glm::dvec2 corner = static_cast<double>(cell_) * glm::dvec2{x, y};
                if (leadsThrough(segment.a, segment.b, corner - reach, corner + (cell_ + reach)))
                    cells_[indexOf({x, y})].push_back(i);
            }
        }
    }
}

glm::ivec2 SegmentGrid::cellOf(glm::dvec2 point) const noexcept {
    return glm::clamp(glm::ivec2{glm::floor(point / static_cast<double>(cell_))}, glm::ivec2{0},
                      glm::ivec2{columns_ - 1, rows_ - 1});
}

}  // namespace inkedge::diff
