#pragma once

#include <cstdint>

#include <inkedge/image.h>

namespace inkedge::diff {

/// Of ink, as inkOfPicture() gives it, the pixels that are left when those that hold nothing together are taken away
/// from its edges: 1 where lines have their middles, a pixel wide, joined as the ink is (8 neighbours), else 0.
[[nodiscard]] Image<std::uint8_t> skeletonOf(const Image<float>& ink);

/// From this much on a pixel is of a line.
inline constexpr float inkedFrom = 0.25F;

}  // namespace inkedge::diff
