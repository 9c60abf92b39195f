#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include <inkedge/image.h>

namespace inkedge {

/// The alpha channel of a PNG picture, 0 to 255; none if the picture has no alpha: it is opaque everywhere.
/// @param mostPixels  the limit
/// @throws Error      (Kind::Input) if it is no PNG or JPEG, damaged, or larger than the limit
[[nodiscard]] std::optional<Image<std::uint8_t>> decodeOpacity(std::span<const std::uint8_t> picture,
                                                               std::uint64_t mostPixels);

/// How much ink each pixel of a PNG picture stands for: 255 where it is black, 0 where it is white or clear.
/// @param mostPixels  the limit
/// @throws Error      (Kind::Input) if it is no PNG, damaged, or larger than the limit
[[nodiscard]] Image<std::uint8_t> decodeInk(std::span<const std::uint8_t> picture, std::uint64_t mostPixels);

}  // namespace inkedge
