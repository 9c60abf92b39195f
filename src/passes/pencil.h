#pragma once

#include <inkedge/settings.h>

#include "gl/gpu.h"

namespace inkedge {

/// Draws a picture's lines several times over, each time a little off. Shader: pencil.frag; CPU definition:
/// reference::pencil().
/// @param drawing   4 channels, on nothing
/// @param tileSide  of what is drawn at once, pixels
/// @return          likewise
[[nodiscard]] Image<std::uint8_t> pencil(gl::Gpu&, const Image<std::uint8_t>& drawing, const StyleSettings&,
                                         int tileSide);

}  // namespace inkedge
