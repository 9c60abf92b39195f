#pragma once

#include <cstdint>
#include <span>

#include <inkedge/image.h>

#include "images/image_formats.h"

namespace inkedge::images {

/// Whether bytes begin with the signature of a PNG.
[[nodiscard]] bool isPng(std::span<const std::uint8_t> bytes) noexcept;

/// The pixels of a PNG: palettes resolved, alpha not premultiplied, values as they are in the file. OpenImageIO is not
/// used, for it prints what is wrong with a PNG on stderr, and leaks memory.
/// @return with a failure, "expected ..., found ...; ...", if the PNG is broken or cut short
[[nodiscard]] ReadPicture readPng(std::span<const std::uint8_t> bytes);

/// The channels that a picture is converted to.
enum class PngChannels {
    GreyAlpha,  ///< 2: the luminance of colours, alpha
    Rgba,       ///< 4
};

/// The pixels of a PNG as it looks: 8 bits a channel in sRGB, whatever the file's bits and gamma. Alpha is not
/// premultiplied, and 255 where the file has none.
/// @param maxPixels  the limit
/// @throws Error     (Kind::Input) if the PNG is damaged or larger than the limit
[[nodiscard]] Image<std::uint8_t> readPngToLookAt(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels,
                                                  PngChannels channels);

/// Whether a PNG says how opaque its pixels are. Reads no pixels.
/// @throws Error  as readPngToLookAt()
[[nodiscard]] bool pngHasAlpha(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels);

}  // namespace inkedge::images
