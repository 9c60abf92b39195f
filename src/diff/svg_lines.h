#pragma once

#include <string_view>

#include <inkedge/compare_lines.h>

namespace inkedge::diff {

/// The lines of an SVG that this library wrote: groups of the class "inkedge" and a type of lines; others are left out.
/// @throws Error  (Kind::Input) if it is none, or widths of its lines vary, so that it has outlines of areas instead
[[nodiscard]] ComparedLines linesOfSvg(std::string_view text);

}  // namespace inkedge::diff
