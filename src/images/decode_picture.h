#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <inkedge/image.h>

namespace inkedge {

/// A picture's pixels: 4 channels, RGB as in the file (sRGB) and alpha, not multiplied in. JPEG needs the module of
/// image formats, which takes half a second to open.
/// @param mostPixels  the limit
/// @throws Error      (Kind::Input) if it is no PNG or JPEG, damaged, or larger than the limit
[[nodiscard]] Image<std::uint8_t> decodePicture(std::span<const std::uint8_t> picture, std::uint64_t mostPixels);

/// The alpha channel of a picture, 0 to 255; none if it has no alpha, as JPEG: it is opaque everywhere.
/// @throws Error  as decodePicture()
[[nodiscard]] std::optional<Image<std::uint8_t>> decodeOpacity(std::span<const std::uint8_t> picture,
                                                               std::uint64_t mostPixels);

/// How much ink each pixel of a PNG picture stands for: 255 where it is black, 0 where it is white or clear.
/// @throws Error  (Kind::Input) if it is no PNG, damaged, or larger than the limit
[[nodiscard]] Image<std::uint8_t> decodeInk(std::span<const std::uint8_t> picture, std::uint64_t mostPixels);

}  // namespace inkedge
