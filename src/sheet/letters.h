#pragma once

#include <string>
#include <string_view>

#include <glm/vec2.hpp>

#include "io/path.h"

namespace inkedge::sheet {

/// Letters of single strokes, as plotters write them, after ISO 3098-1 type B, upright: capitals, digits and the signs
/// of drawings. They need no font, in no format. Small letters are written as capitals.

/// The width of lines that letters of a height are written with.
[[nodiscard]] constexpr double lineWidthOf(double height) noexcept { return 0.1 * height; }

/// @param text    UTF-8
/// @param height  of capitals
/// @return        in the unit of the height
[[nodiscard]] double widthOf(std::string_view text, double height);

/// Adds a text to a path.
/// @param at  the left end of the line that the letters stand on, y down
void write(io::Path&, std::string_view text, glm::dvec2 at, double height);

/// The characters of a text that there are no letters for, each once; a box is written for each.
[[nodiscard]] std::string unknownIn(std::string_view text);

}  // namespace inkedge::sheet
