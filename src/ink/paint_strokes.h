#pragma once

#include <array>
#include <span>

#include <glm/vec2.hpp>

#include <inkedge/image.h>
#include <inkedge/settings.h>

namespace inkedge {

/// A straight stroke with round caps. Coordinates are output pixels, (0, 0) the picture's top left corner.
struct Stroke {
    glm::vec2 from;
    glm::vec2 to;
    std::uint8_t style;  ///< 0..lineTypeCount-1: which line type's width and colour
};

/// Width in output pixels and colour of one line type, overrides applied.
struct Pen {
    double width;
    Color color;
};
[[nodiscard]] std::array<Pen, lineTypeCount> pens(const PictureSettings&);

/// Draws strokes with exact coverage at any width: a pixel's coverage is the share of its square that the stroke's band
/// covers; at caps, the band along the cap's tangent. Strokes of one colour join without a seam; of two colours the
/// line type that comes first covers.
/// @return  1, 3 or 4 channels, as Maps::picture
[[nodiscard]] Image<std::uint8_t> paintStrokes(std::span<const Stroke>, const PictureSettings&);

}  // namespace inkedge
