#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lines/screen.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// A segment in the picture, what lies before the near plane cut off.
struct ScreenSegment {
    std::array<ScreenPoint, 2> ends;
    std::array<glm::dvec3, 2> world;  ///< less the centre of the scene's bounds
};

/// Projects segments. Those behind the near plane or wholly off the picture, by more than a margin in pixels, are taken
/// out of both lists; of those that cross the near plane the end behind it moves there and loses its key.
[[nodiscard]] std::vector<ScreenSegment> project(std::vector<Segment>&, const Screen&);

/// Segments that go on into each other.
struct Chain {
    struct Link {
        std::uint32_t segment;
        bool reversed;  ///< it runs from its second end to its first
    };
    std::vector<Link> links;
    bool closed = false;
};

/// Joins drawn segments of one curve type and one instance end to end; marked ones, and those known as hidden
/// (Segment::hidden), with each other only. Where more than two meet, those go on into each
/// other that do so most straightly in the picture, if they bend by under 60 degrees. O(n log n).
[[nodiscard]] std::vector<Chain> chainSegments(std::span<const Segment>, std::span<const ScreenSegment>);

}  // namespace inkedge::lines
