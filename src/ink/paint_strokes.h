#pragma once

#include <span>

#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "ink/brush.h"
#include "ink/stroke.h"
#include "settings/picture_channels.h"

namespace inkedge::ink {

/// Draws strokes with exact coverage at any width. The coverage of a pixel is the share of its square that the stroke's
/// band covers. At a cap it is the band along the cap's tangent; where the width varies, the band as wide as the stroke
/// is beside the pixel's centre. Strokes of one colour join without a seam. Of two colours the one whose line type
/// comes first covers the other; visible lines cover hidden ones.
/// @param brush  drawn along each line; null: full ink. A pixel takes the brush's ink where the line is nearest to the
///               pixel; where lines of one colour meet, the larger ink.
/// @return  1, 3 or 4 channels, as Maps::picture
[[nodiscard]] Image<std::uint8_t> paintStrokes(std::span<const Stroke>, const PictureSettings&,
                                               const Brush* brush = nullptr,
                                               settings::Paper = settings::Paper::Background);

}  // namespace inkedge::ink
