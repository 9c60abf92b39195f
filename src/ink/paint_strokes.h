#pragma once

#include <span>

#include <glm/vec2.hpp>

#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "ink/brush.h"
#include "ink/pens.h"

namespace inkedge {

/// Stroke::widthFrom and ::widthTo of a stroke as wide as its pen.
inline constexpr std::uint8_t fullWidth = 128;

/// A straight stroke with round caps. Coordinates are output pixels, (0, 0) the picture's top left corner.
struct Stroke {
    glm::vec2 from;
    glm::vec2 to;
    std::uint8_t style;                  ///< 0..penCount-1: which of pens()
    std::uint8_t widthFrom = fullWidth;  ///< 128ths of the pen's width
    std::uint8_t widthTo = fullWidth;    ///< between the two it changes evenly
    float arc = 0.0F;  ///< pixels of way along its line before it, for a brush; 0 begins a line, whose strokes follow
};

/// Draws strokes with exact coverage at any width: a pixel's coverage is the share of its square that the stroke's band
/// covers; at caps, the band along the cap's tangent; where its width varies, the band as wide as it is beside the
/// pixel's centre. Strokes of one colour join without a seam; of two colours the
/// line type that comes first covers, and what is seen covers what is hidden.
/// @param brush  laid along each line, none: full ink. A pixel takes the brush's ink where its line is nearest to it;
///               where lines of one colour meet, the larger ink.
/// @return  1, 3 or 4 channels, as Maps::picture
[[nodiscard]] Image<std::uint8_t> paintStrokes(std::span<const Stroke>, const PictureSettings&,
                                               const Brush* brush = nullptr);

}  // namespace inkedge
