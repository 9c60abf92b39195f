#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/compare_lines.h>

namespace inkedge::diff {

/// Pixels, with the way back to the start of a closed line.
[[nodiscard]] double lengthOf(const ComparedLine&);

/// A straight piece of a line.
struct Segment {
    glm::dvec2 a;
    glm::dvec2 b;
    std::uint32_t line = 0;     ///< index of the line
    std::uint32_t samples = 1;  ///< it is cut into so many pieces of one length, in the middle of each a sample
    std::size_t first = 0;      ///< index of its first sample
};

/// A point of a line, which stands for a piece of it.
struct Sample {
    glm::dvec2 at;
    /// Unit length: which way the line goes, over two pixels to both sides; 0 where it turns round there, so that it
    /// goes no way. Lines between pixels zigzag by as much as a pixel.
    glm::dvec2 along;
    double length;  ///< pixels of the piece
    std::uint32_t segment;
};

inline constexpr double sampleStep = 0.5;  ///< pixels between the samples of a segment at the largest

/// Lines as segments and samples, each in the order of the lines.
struct SampledLines {
    explicit SampledLines(std::span<const ComparedLine>);

    [[nodiscard]] std::uint32_t lineOf(const Sample& sample) const noexcept { return segments[sample.segment].line; }

    std::vector<Segment> segments;
    std::vector<Sample> samples;
    std::vector<std::size_t> firstOfLine;  ///< index of each line's first sample, then of the end

private:
    void measureDirections(std::size_t first, bool closed);
};

/// The point of a segment that is nearest to another.
struct Nearest {
    std::uint32_t segment = 0;
    double share = 0.0;  ///< of the segment, from a to b
    glm::dvec2 at{0.0};
    double squaredDistance = 0.0;
};
[[nodiscard]] Nearest nearestOn(const Segment&, std::uint32_t index, glm::dvec2 point) noexcept;

/// Segments, found again by the cells of the picture that they pass within reach of. Refers to them.
class SegmentGrid {
public:
    SegmentGrid(std::span<const Segment>, Size, double reach);

    /// Calls visit(Nearest) for every segment within reach of a point of the picture.
    template <class Visit>
    void visitNear(glm::dvec2 point, Visit&& visit) const {
        for (const std::uint32_t i : cells_[indexOf(cellOf(point))]) {
            const Nearest nearest = nearestOn(segments_[i], i, point);
            if (nearest.squaredDistance <= reach_ * reach_) visit(nearest);
        }
    }

    /// Whether a segment is within reach of a point of the picture.
    [[nodiscard]] bool hasNear(glm::dvec2 point) const {
        return std::ranges::any_of(cells_[indexOf(cellOf(point))], [&](std::uint32_t i) {
            return nearestOn(segments_[i], i, point).squaredDistance <= reach_ * reach_;
        });
    }

private:
    [[nodiscard]] glm::ivec2 cellOf(glm::dvec2 point) const noexcept;
    [[nodiscard]] std::size_t indexOf(glm::ivec2 at) const noexcept {
        return static_cast<std::size_t>(at.y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(at.x);
    }

    std::span<const Segment> segments_;
    double reach_;
    int cell_;  // pixels
    int columns_;
    int rows_;
    std::vector<std::vector<std::uint32_t>> cells_;
};

}  // namespace inkedge::diff
