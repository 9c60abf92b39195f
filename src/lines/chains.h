#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/screen.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// The part of a segment behind the near plane, projected to the picture.
struct ScreenSegment {
    std::array<ScreenPoint, 2> ends;
    std::array<glm::dvec3, 2> world;  ///< less the centre of the scene's bounds
};

/// Projects segments. Segments before the near plane, or off the picture by more than a margin, are removed from both
/// lists. Where a segment crosses the near plane its end before the plane moves to the plane and loses its key.
[[nodiscard]] std::vector<ScreenSegment> project(std::vector<Segment>&, const Screen&);

/// Segments that go on into each other.
struct Chain {
    struct Link {
        std::uint32_t segment;
        bool reversed;  ///< the chain runs from the segment's second end to its first
    };
    std::vector<Link> links;
    bool closed = false;
};

/// Joins drawn segments of one curve type and one instance end to end. Marked segments are joined with marked ones
/// only, and so are those known to be hidden (Segment::hidden). Where more than two segments meet, the two that are
/// straightest in the picture are joined first, if they bend by under 60 degrees. O(n log n).
[[nodiscard]] std::vector<Chain> chainSegments(std::span<const Segment>, std::span<const ScreenSegment>);

}  // namespace inkedge::lines
