#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/export.h>
#include <inkedge/image.h>

namespace inkedge {

/// A picture as a PNG file's bytes: 1 channel grey, 3 RGB, 4 RGBA, 8 bits each; 3 and 4 by a
/// palette if the picture has few colours.
[[nodiscard]] INKEDGE_API std::vector<std::uint8_t> encodePng(const Image<std::uint8_t>&);

/// Values of 16 bits as a PNG file's bytes: Maps::types as grey whose value is the bits. 1, 3 or 4 channels.
/// @throws Error  (Kind::Usage) if there is no pixel or another number of channels
[[nodiscard]] INKEDGE_API std::vector<std::uint8_t> encodePng(const Image<std::uint16_t>&);

}  // namespace inkedge
