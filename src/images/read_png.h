#pragma once

#include <cstdint>
#include <span>

#include <inkedge/image.h>

#include "images/image_formats.h"

namespace inkedge::io {

/// Whether bytes begin as every PNG does.
[[nodiscard]] bool isPng(std::span<const std::uint8_t> bytes) noexcept;

/// A PNG's pixels, palettes resolved, alpha not multiplied in, values as they are in the file. Not read by
/// OpenImageIO, which tells stderr what is wrong with a PNG and leaks.
/// @return with a failure, "expected ..., found ...; ...", if it is broken or cut short
[[nodiscard]] ReadPicture readPng(std::span<const std::uint8_t> bytes);

/// Channels to bring a picture to.
enum class PngChannels {
    GreyAlpha,  ///< 2: the luminance of colours, alpha
    Rgba,       ///< 4
};

/// A PNG's pixels to look at: 8 bits a channel in sRGB, whatever the file's bits and gamma; alpha is not multiplied in,
/// and 255 where the file has none.
/// @param mostPixels  the limit
/// @throws Error      (Kind::Input) if it is damaged or larger than the limit
[[nodiscard]] Image<std::uint8_t> readPngToLookAt(std::span<const std::uint8_t> bytes, std::uint64_t mostPixels,
                                                  PngChannels channels);

/// Whether a PNG says how opaque its pixels are. Reads no pixels.
/// @throws Error  as readPngToLookAt()
[[nodiscard]] bool pngHasAlpha(std::span<const std::uint8_t> bytes, std::uint64_t mostPixels);

}  // namespace inkedge::io
