#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/export.h>
#include <inkedge/image.h>

namespace inkedge {

/// A picture as a PNG file's bytes: 1 channel grey, 3 RGB, 4 RGBA, 8 bits each; 3 and 4 by a
/// palette if the picture has few colours.
[[nodiscard]] INKEDGE_API std::vector<std::uint8_t> encodePng(const Image<std::uint8_t>&);

}  // namespace inkedge
