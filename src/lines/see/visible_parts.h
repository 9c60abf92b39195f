#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lines/chains.h"
#include "lines/see/crossings.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// What is seen at one place of a segment.
enum class Seen : std::uint8_t {
    Hidden,
    Outline,  ///< a contour or boundary with nothing behind it
    Inside,   ///< anything else that is seen
    Seam,     ///< a boundary across which another surface goes on: no line
};

/// A part of a chain that looks the same throughout. Places count segments: 2.25 is a quarter along the third in the
/// picture. In a closed chain the last part may go on over the chain's start: it then ends beyond the number of
/// segments.
struct Part {
    double begin;
    double end;
    Seen seen;
};

[[nodiscard]] constexpr bool isSeen(Seen seen) noexcept { return seen == Seen::Outline || seen == Seen::Inside; }

/// Judges a place of a segment, 0 to 1 in the picture. Called by several threads at once.
using Judge = std::function<Seen(std::uint32_t segment, double at)>;

inline constexpr double sampleStep = 6.0;  ///< pixels

/// Parts a chain where what is seen changes: at crossings, at its joints, and where two samples between these
/// disagree. Pieces between crossings are sampled at least every sampleStep pixels and bisected where samples disagree; where
/// a part ends at a crossing it is looked at again half a pixel from there, and on back to where it is what it was
/// taken for. Hidden parts shorter than longestGap between seen ones count as seen, and seen ones shorter than
/// leastPart as hidden, first those beside what stays hidden: both are the mesh's facets, not the shape's.
[[nodiscard]] std::vector<Part> partChain(const Chain&, std::span<const ScreenSegment>,
                                          std::span<const Crossing> crossings,
                                          std::span<const std::uint32_t> firstCrossings, const Judge&);

inline constexpr double longestGap = 2.5;
inline constexpr double leastPart = 1.0;

}  // namespace inkedge::lines
