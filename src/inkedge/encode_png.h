#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <inkedge/export.h>
#include <inkedge/image.h>

namespace inkedge {

/// A picture as the bytes of a PNG file of 8 bits a channel: 1 channel is grey, 3 are RGB, 4 RGBA. A picture of few
/// colours is written with a palette.
/// @param dpi  pixels per inch, over 0, which the file tells, rounded to whole pixels a metre (pHYs); none: it does not
[[nodiscard]] INKEDGE_API std::vector<std::uint8_t> encodePng(const Image<std::uint8_t>&,
                                                              std::optional<double> dpi = {});

/// Values of 16 bits as the bytes of a PNG file of 1, 3 or 4 channels. Maps::types becomes grey: a value's bits are
/// the types.
/// @throws Error  (Kind::Usage) if there is no pixel or another number of channels
[[nodiscard]] INKEDGE_API std::vector<std::uint8_t> encodePng(const Image<std::uint16_t>&,
                                                              std::optional<double> dpi = {});

}  // namespace inkedge
