#pragma once

#include <span>

#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "ink/brush.h"
#include "ink/stroke.h"
#include "settings/picture_channels.h"

namespace inkedge {

/// Draws strokes with exact coverage at any width: a pixel's coverage is the share of its square that the stroke's band
/// covers; at caps, the band along the cap's tangent; where its width varies, the band as wide as it is beside the
/// pixel's centre. Strokes of one colour join without a seam; of two colours the line type that comes first covers, and
/// what is seen covers what is hidden.
/// @param brush  laid along each line, none: full ink. A pixel takes the brush's ink where its line is nearest to it;
///               where lines of one colour meet, the larger ink.
/// @return  1, 3 or 4 channels, as Maps::picture
[[nodiscard]] Image<std::uint8_t> paintStrokes(std::span<const Stroke>, const PictureSettings&,
                                               const Brush* brush = nullptr, Paper = Paper::Background);

}  // namespace inkedge
