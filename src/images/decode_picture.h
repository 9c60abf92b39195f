#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <inkedge/image.h>

namespace inkedge::images {

/// The pixels of a picture: 4 channels, RGB as in the file (sRGB) and alpha, not premultiplied. JPEG needs the module
/// of image formats, which takes half a second to open.
/// @param maxPixels  the limit
/// @throws Error     (Kind::Input) if it is no PNG, JPEG or WebP, damaged, or larger than the limit
[[nodiscard]] Image<std::uint8_t> decodePicture(std::span<const std::uint8_t> picture, std::uint64_t maxPixels);

/// The alpha channel of a picture, 0 to 255; none if the picture has no alpha, as a JPEG: it is opaque everywhere.
/// @throws Error  as decodePicture()
[[nodiscard]] std::optional<Image<std::uint8_t>> decodeOpacity(std::span<const std::uint8_t> picture,
                                                               std::uint64_t maxPixels);

/// How much ink each pixel of a PNG picture stands for: 255 where the pixel is black, 0 where it is white or
/// transparent.
/// @throws Error  (Kind::Input) if it is no PNG, damaged, or larger than the limit
[[nodiscard]] Image<std::uint8_t> decodeInk(std::span<const std::uint8_t> picture, std::uint64_t maxPixels);

}  // namespace inkedge::images
