#pragma once

#include <vector>

#include <inkedge/lines.h>

namespace inkedge::lines {

inline constexpr double minLineLength = 0.1;  ///< pixels

/// Leaves out lines shorter than minLineLength: edges along the view, and scraps where lines end. O(points).
void leaveOutSpecks(std::vector<Line>&);

}  // namespace inkedge::lines
