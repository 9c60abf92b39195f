#pragma once

#include <vector>

#include "trace/traced_piece.h"

namespace inkedge::trace {

/// Leaves out scraps, as lines::leaveOutScraps() does: pieces that hang together, may all be scraps, are less than
/// lines::minScrapLength long, and reach no other piece within lines::scrapReach. The order of the others stays. O(n
/// log n).
void leaveOutScraps(std::vector<TracedPiece>&);

}  // namespace inkedge::trace
