#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/compare_lines.h>

#include "diff/samples.h"

namespace inkedge::diff {

/// What has become of a sample.
enum class Fate : std::uint8_t {
    Same,     ///< the other side has a line there
    Changed,  ///< it has one of another type or visibility, for which this side has none
    Moved,    ///< it has one farther away, for which this side has none
    Gone,     ///< it has none
};

/// A sample's counterpart on the other side.
struct Match {
    Fate fate = Fate::Gone;
    std::uint32_t line = 0;  ///< unless it is gone: of the other side
    std::size_t sample = 0;  ///< and its sample there
    glm::dvec2 way{0.0};     ///< from here to the nearest point there
};

/// One side of a comparison.
struct Side {
    Side(const ComparedLines& all, double distance, double reach)
        : lines{all.lines},
          sampled{all.lines},
          near{sampled.segments, all.size, distance},
          around{sampled.segments, all.size, reach},
          matches(sampled.samples.size()) {}

    std::span<const ComparedLine> lines;
    SampledLines sampled;
    SegmentGrid near;    ///< within the tolerance's distance
    SegmentGrid around;  ///< as far as lines may have moved
    std::vector<Match> matches;
};

/// How the samples of one line moved onto another.
struct LineMove {
    std::uint32_t before = 0;  ///< lines
    std::uint32_t after = 0;
    double distance = 0.0;          ///< as LineChange::distance
    std::optional<glm::dvec2> way;  ///< as LineChange::way
};

/// Finds what has become of each sample of both sides.
/// @return  of each pair of lines of which samples moved, in the order of before, then after
[[nodiscard]] std::vector<LineMove> matchSides(Side& before, Side& after, double distance);

}  // namespace inkedge::diff
