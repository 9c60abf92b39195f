#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/chains.h"
#include "lines/screen.h"
#include "lines/see/surface_parts.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// Where in the picture a drawn segment passes behind a contour or a boundary: there it may become hidden, or seen.
struct Crossing {
    std::uint32_t segment;
    double at;  ///< 0 to 1 between the segment's ends in the picture
};

/// All of them, by segment and place: case 1 of section 3.4 of Hertzmann 1999, with segments sorted into a grid as
/// Markosian et al. 1997 do. Segments that have an end in common do not cross.
/// @param parts  a smooth contour's slack is that of its own part only; null: all are one
/// O(n + pairs in a cell).
[[nodiscard]] std::vector<Crossing> findCrossings(std::span<const Segment>, std::span<const ScreenSegment>,
                                                  const Screen&, const SurfaceParts* parts = nullptr);

}  // namespace inkedge::lines
