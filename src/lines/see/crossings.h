#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/chains.h"
#include "lines/screen.h"
#include "lines/see/surface_components.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// A point of the picture where a drawn segment passes behind a contour or a boundary: its visibility may change there.
struct Crossing {
    std::uint32_t segment;
    double at;  ///< 0 to 1 between the segment's ends in the picture
};

/// All crossings, ordered by segment, then along the segment: case 1 of section 3.4 of Hertzmann 1999, with segments
/// sorted into a grid as by Markosian et al. 1997. Segments that have an end in common do not cross.
/// @param components  a smooth contour's slack is for its own component only; null: the scene is one component
/// O(n + pairs in a cell).
[[nodiscard]] std::vector<Crossing> findCrossings(std::span<const Segment>, std::span<const ScreenSegment>,
                                                  const Screen&, const SurfaceComponents* components = nullptr);

}  // namespace inkedge::lines
