#pragma once

#include <vector>

#include <inkedge/compare_lines.h>

#include "diff/match.h"

namespace inkedge::diff {

/// Makes changes of what has become of samples: runs of one fate along a line, joined where they go on into each other,
/// the short ones left out. Fills in all of the comparison but its size, tolerance and verdict.
void collectChanges(const Side& before, const Side& after, const std::vector<LineMove>&, LinesComparison&);

}  // namespace inkedge::diff
