#pragma once

#include <span>

#include <inkedge/line_types.h>
#include <inkedge/lines.h>

namespace inkedge::lines {

/// Pixels of the lines of each type that are seen, in the picture or beyond its edge.
[[nodiscard]] LineLengths lengthsOf(std::span<const Line>);

}  // namespace inkedge::lines
