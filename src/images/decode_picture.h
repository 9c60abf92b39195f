#pragma once

#include <cstdint>
#include <span>

#include <inkedge/image.h>

namespace inkedge {

/// A picture's pixels: 4 channels, RGB as in the file (sRGB) and alpha, not multiplied in. JPEG needs the module of
/// image formats, which takes half a second to open.
/// @param mostPixels  the limit
/// @throws Error      (Kind::Input) if it is no PNG or JPEG, damaged, or larger than the limit
[[nodiscard]] Image<std::uint8_t> decodePicture(std::span<const std::uint8_t> picture, std::uint64_t mostPixels);

}  // namespace inkedge
