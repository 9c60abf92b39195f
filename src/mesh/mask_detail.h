#pragma once

#include <inkedge/image.h>

namespace inkedge::mesh {

/// A mask at half its resolution, rounded down, but at least one texel: each texel is the mean of what it covers.
/// @param mask  one channel
[[nodiscard]] Image<std::uint8_t> halved(const Image<std::uint8_t>& mask);

/// About how many corners the outlines of a mask's opaque parts have: those of noise have about one for each texel,
/// smooth ones few. O(texels).
/// @param half       halved(mask): what of the outlines is still there is smooth
/// @param threshold  the mask is opaque where its opacity is at least this
[[nodiscard]] double outlineCorners(const Image<std::uint8_t>& mask, const Image<std::uint8_t>& half, double threshold);

}  // namespace inkedge::mesh
