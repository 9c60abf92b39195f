#pragma once

#include <vector>

#include <inkedge/image.h>

#include "passes/frame.h"
#include "raster/rectangle.h"

namespace inkedge::passes {

/// Finds where the faces of neighbouring pixels do not go on into each other. Shader: detect_lines.frag; CPU
/// definition: reference::detectLines(), which it equals but for decisions within float rounding.
/// @param planes  as PlaneBuffers::planes, of this frame
/// @param creaseAngle  degrees
/// @return        PairMark bits (raster/pair_mark.h), one byte a pixel, row 0 at the top: the low four bits for the
///                pixel and the one to its right, the high four for the pixel and the one below
[[nodiscard]] Image<std::uint8_t> detectLines(const Frame&, const gl::Texture& planes, double creaseAngle);

/// Parts of a picture, apart from each other, that hold all marked pixels and the eight around each: what has to be
/// read to trace the lines there.
[[nodiscard]] std::vector<raster::Rectangle> regionsAround(const Image<std::uint8_t>& marks);

}  // namespace inkedge::passes
