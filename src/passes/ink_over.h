#pragma once

#include <inkedge/image.h>
#include <inkedge/settings.h>

namespace inkedge::passes {

/// The mean of each pixel's samples.
[[nodiscard]] Image<std::uint8_t> meanOf(Image<std::uint8_t>, int samplesPerPixel);

/// The darker of two layers of ink at each pixel; an empty image is no ink.
[[nodiscard]] Image<std::uint8_t> darker(Image<std::uint8_t>, const Image<std::uint8_t>&);

/// 255 where a pixel has at least half of full ink, else 0; an empty image is no ink.
[[nodiscard]] Image<std::uint8_t> maskOf(const Image<std::uint8_t>& ink, Size);

/// Draws the line colour over a picture.
/// @param ink      one channel of the picture's size: how much ink covers of each pixel, 0 to 255
/// @param picture  1, 3 or 4 channels, as Maps::picture
void inkOver(const Image<std::uint8_t>& ink, const PictureSettings&, Image<std::uint8_t>& picture);

/// Paints a drawing on what lies under it, and that on the background.
/// @param drawing  4 channels, on a transparent background
/// @param shade    as Maps::shade; empty: there is none
/// @return         as Maps::picture
[[nodiscard]] Image<std::uint8_t> onBackground(Image<std::uint8_t> drawing, const Image<std::uint8_t>& shade,
                                               const PictureSettings&);

}  // namespace inkedge::passes
