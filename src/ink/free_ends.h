#pragma once

#include <vector>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

namespace inkedge::ink {

/// The free ends of open drawn lines: those where no line goes on or meets the end. A line ends freely where it runs
/// behind another surface, or simply runs out.
///
/// A line goes on if, within 1.5 pixels of the end, another line or the line itself leads on for more than 1.5 pixels,
/// bent by under 45 degrees: as where the type of a line changes. A line meets an end within half a pixel in the
/// picture and 4 pixel footprints in space, as in the corner of a solid; but not if it ends there too and comes from
/// the same side, at under 25 degrees: both then run out in one tip.
class FreeEnds {
public:
    /// O(n log n), except where very many ends are near each other.
    FreeEnds(const Lines&, const PictureSettings&, const LineSettings&);

    /// @param end  an end of one of the lines
    [[nodiscard]] bool has(const LinePoint& end) const;

private:
    std::vector<LinePoint> joined_;  // the ends that are not free, sorted
};

}  // namespace inkedge::ink
