#pragma once

#include <functional>
#include <span>
#include <vector>

#include "lines/chains.h"
#include "lines/see/crossings.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// How one point of a segment is seen.
enum class Seen : std::uint8_t {
    Hidden,
    Outline,  ///< a contour or boundary with nothing behind it
    Contact,  ///< where another surface touches, with something behind it
    Inside,   ///< anything else that is seen
    Seam,     ///< a boundary across which another surface goes on: no line
};

/// A part of a chain that is seen the same way throughout. Positions along a chain count segments: 2.25 is a quarter
/// along the third segment in the picture. In a closed chain the last part may go on over the chain's start: its end is
/// then over the number of segments.
struct Part {
    double begin;
    double end;
    Seen seen;
};

[[nodiscard]] constexpr bool isSeen(Seen seen) noexcept {
    return seen == Seen::Outline || seen == Seen::Contact || seen == Seen::Inside;
}

/// Judges how a point of a segment is seen. Called by several threads at once.
/// @param at  0 to 1 between the segment's ends in the picture
using Judge = std::function<Seen(std::uint32_t segment, double at)>;

inline constexpr double sampleStep = 6.0;  ///< pixels

/// Divides a chain into parts where the way in which it is seen changes: at crossings, at its joints, and where two
/// samples between these disagree.
///
/// Pieces between crossings are sampled at least every sampleStep pixels, and bisected where samples disagree. A part
/// that ends at a crossing is looked at again half a pixel from its end; if it is seen otherwise there the end moves
/// back, in steps, to where it is seen as its samples are. Hidden parts shorter than maxGap between visible ones count
/// as visible, and visible parts shorter than minPart as hidden, first those beside parts that stay hidden. Both come
/// from the facets of the mesh, not from the shape.
[[nodiscard]] std::vector<Part> partChain(const Chain&, std::span<const ScreenSegment>,
                                          std::span<const Crossing> crossings,
                                          std::span<const std::uint32_t> firstCrossings, const Judge&);

inline constexpr double maxGap = 2.5;   ///< pixels
inline constexpr double minPart = 1.0;  ///< pixels

}  // namespace inkedge::lines
