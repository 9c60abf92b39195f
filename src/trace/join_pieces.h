#pragma once

#include <span>
#include <vector>

#include <inkedge/lines.h>
#include <inkedge/scene.h>

#include "lines/screen.h"
#include "trace/traced_piece.h"

namespace inkedge::trace {

/// Joins pieces to polylines, one a type and node: section 2.2 of Hertzmann 1999. Junctions and gaps are treated as
/// those of lines from object space are. What is under two pixels between others takes their type, and is left out
/// where it only begins or ends on one.
[[nodiscard]] std::vector<Line> joinPieces(std::span<const TracedPiece>, const Scene&, const lines::Screen&);

}  // namespace inkedge::trace
