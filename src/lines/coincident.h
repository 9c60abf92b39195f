#pragma once

#include <vector>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "lines/screen.h"

namespace inkedge::lines {

inline constexpr double coincidentWithin = 0.1;  ///< pixels between two lines that fall on each other
inline constexpr double minCoincident = 2.0;     ///< pixels along each other; shorter lines: all of the line
/// Pixels between a hidden line and another on which it falls, or the width of its pen if that is more: dashes nearer
/// than that to others fill the gaps of these.
inline constexpr double minHiddenWithin = 0.5;

/// Leaves one of the lines that run along each other, coincidentWithin apart in the picture: the seen one, of several
/// the nearest, and of those as near to the eye the one whose type comes first in LineType. It is then of the first
/// type that any of the seen ones had. Other lines end where it begins, and go on where it ends; what would be left of
/// them there is dropped if it is under minPart.
///
/// Hidden lines fall on others from further off, minHiddenWithin. They are cut where they run along another for a dash
/// and a gap at least, and what is left between two cuts is dropped if it is shorter, and no further off than twice
/// that distance: lines round the same hole, of different facets, are one. Lines that only cross cut neither, however
/// many do so in a row.
///
/// Lines that are not drawn are left alone, and hide no other.
/// @param origin  the origin of the screen's world space
/// O(n + pairs in a cell).
[[nodiscard]] std::vector<Line> mergeCoincident(std::vector<Line>, const PictureSettings&, const Screen&,
                                                glm::dvec3 origin);

}  // namespace inkedge::lines
