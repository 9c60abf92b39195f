#pragma once

#include <inkedge/image.h>
#include <inkedge/settings.h>

namespace inkedge {

/// The mean of each pixel's samples.
[[nodiscard]] Image<std::uint8_t> meanOf(Image<std::uint8_t>, int samplesPerPixel);

/// Of two layers of ink the darker at each pixel; an empty one is none.
[[nodiscard]] Image<std::uint8_t> darker(Image<std::uint8_t>, const Image<std::uint8_t>&);

/// 255 where there is at least half of the ink that a pixel takes, else 0. Empty ink is none.
[[nodiscard]] Image<std::uint8_t> maskOf(const Image<std::uint8_t>& ink, Size);

/// Draws the line colour over a picture.
/// @param ink      one channel of the picture's size: how much of each pixel it covers, 0 to 255
/// @param picture  1, 3 or 4 channels, as Maps::picture
void inkOver(const Image<std::uint8_t>& ink, const PictureSettings&, Image<std::uint8_t>& picture);

/// Lays a drawing on the background.
/// @param drawing  4 channels, on nothing
/// @return         as Maps::picture
[[nodiscard]] Image<std::uint8_t> onBackground(Image<std::uint8_t> drawing, const PictureSettings&);

}  // namespace inkedge
