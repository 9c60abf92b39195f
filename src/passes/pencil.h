#pragma once

#include <inkedge/settings.h>

#include "gl/gpu.h"

namespace inkedge::passes {

/// Draws a picture's lines several times, each time a little off. Shader: pencil.frag; CPU definition:
/// reference::pencil().
/// @param drawing   4 channels, on a transparent background
/// @param tileSide  of what is drawn at once, pixels
/// @return          4 channels, on a transparent background
[[nodiscard]] Image<std::uint8_t> pencil(gl::Gpu&, const Image<std::uint8_t>& drawing, const StyleSettings&,
                                         int tileSide);

}  // namespace inkedge::passes
