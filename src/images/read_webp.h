#pragma once

#include <cstdint>
#include <span>

#include <inkedge/image.h>

namespace inkedge::images {

/// Whether bytes begin with the signature of a WebP.
[[nodiscard]] bool isWebp(std::span<const std::uint8_t> bytes) noexcept;

/// The pixels of a WebP: RGB as in the file (sRGB) and alpha, 255 where the file has none; not premultiplied.
/// @param maxPixels  the limit
/// @throws Error     (Kind::Input) if the WebP is damaged, an animation, or larger than the limit
[[nodiscard]] Image<std::uint8_t> readWebp(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels);

/// Whether a WebP says how opaque its pixels are. Reads no pixels.
/// @throws Error  as readWebp()
[[nodiscard]] bool webpHasAlpha(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels);

}  // namespace inkedge::images
