#pragma once

#include <vector>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

namespace inkedge {

/// The ends of open drawn lines where none goes on or meets them: where a line runs behind another surface, or out on
/// its own.
///
/// A line goes on where another one, or it itself, leads on for more than 1.5 pixels from within 1.5 pixels, bent by
/// under 45 degrees, as where its type changes. It meets another, as in a solid's corners, within half a pixel in the
/// picture and 4 pixels across in space; not one that ends there too and comes from the same side, at under 25 degrees:
/// they run out in one tip.
class FreeEnds {
public:
    /// O(n log n), but for ends that crowd.
    FreeEnds(const Lines&, const PictureSettings&, const LineSettings&);

    /// @param end  an end of one of the lines
    [[nodiscard]] bool has(const LinePoint& end) const;

private:
    std::vector<LinePoint> joined_;  // the others, in order of place
};

}  // namespace inkedge
