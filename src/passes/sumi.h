#pragma once

#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "passes/frame.h"

namespace inkedge::passes {

/// A soft brush: how much ink each pixel takes, 0 to 255. Shaders: sumi_channels.frag, blur.frag, sumi_gradients.frag,
/// sumi_tangents.frag, sumi_brush.frag; CPU definition: reference::sumi().
/// @param frame    in pixels
/// @param surface  as SurfaceBuffers::surface; left unchanged
[[nodiscard]] Image<std::uint8_t> sumi(const Frame& frame, const gl::Texture& surface, const StyleSettings&);

/// The radius in pixels around a pixel on which the pixel's ink depends.
[[nodiscard]] int sumiReach(const StyleSettings&);

}  // namespace inkedge::passes
