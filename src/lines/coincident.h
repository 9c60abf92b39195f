#pragma once

#include <vector>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "lines/screen.h"

namespace inkedge::lines {

inline constexpr double coincidentWithin = 0.1;  ///< pixels between two lines that fall on each other
inline constexpr double minCoincident = 2.0;     ///< pixels along each other; shorter lines: all of the line

/// Leaves one of the lines that run along each other, coincidentWithin apart in the picture: the seen one, of several
/// the nearest, and of those as near to the eye the one whose type comes first in LineType. It is then of the first
/// type that any of the seen ones had. Other lines end where it begins, and go on where it ends; what would be left of
/// them there is dropped if it is under minPart.
///
/// Lines that are not drawn are left alone, and hide no other.
/// @param origin  the origin of the screen's world space
/// O(n + pairs in a cell).
[[nodiscard]] std::vector<Line> mergeCoincident(std::vector<Line>, const PictureSettings&, const Screen&,
                                                glm::dvec3 origin);

}  // namespace inkedge::lines
