#pragma once

#include <span>

#include <inkedge/image.h>

#include "gl/gpu.h"
#include "raster/rectangle.h"
#include "raster/samples.h"

namespace inkedge::gl {

/// Copies a texture to host memory, row 0 first.
/// @param channels  how many of the texture's channels to take, from the first: 1 to 4
[[nodiscard]] Image<float> readFloats(const Api&, const Texture&, int channels);
/// The values of an R32UI texture.
[[nodiscard]] Image<std::uint32_t> readIntegers(const Api&, const Texture&);
/// The values of some rectangles of a texture; the others are not read.
[[nodiscard]] raster::Samples<float> readFloats(const Api&, const Texture&, int channels,
                                                std::span<const raster::Rectangle>);
[[nodiscard]] raster::Samples<std::uint32_t> readIntegers(const Api&, const Texture&,
                                                          std::span<const raster::Rectangle>);
/// An RGBA32UI texture as 16 bytes per texel, the low byte of the first component first (on little-endian hosts).
[[nodiscard]] Image<std::uint8_t> readPacked(const Api&, const Texture&);
/// The values of a texture with 8-bit channels.
[[nodiscard]] Image<std::uint8_t> readBytes(const Api&, const Texture&, int channels);
/// The values of a depth texture.
[[nodiscard]] Image<float> readDepth(const Api&, const Texture&);

}  // namespace inkedge::gl
