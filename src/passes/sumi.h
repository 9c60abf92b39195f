#pragma once

#include <inkedge/camera.h>
#include <inkedge/settings.h>

#include "gl/gpu.h"
#include "raster/tiles.h"

namespace inkedge {

/// A soft brush: how much ink each pixel takes, 0 to 255. Shaders: sumi_channels.frag, blur.frag, sumi_gradients.frag,
/// sumi_tangents.frag, sumi_brush.frag; CPU definition: reference::sumi().
/// @param surface  as SurfaceBuffers::surface; left unchanged
[[nodiscard]] Image<std::uint8_t> sumi(gl::Gpu&, const gl::Texture& surface, const Camera&, const StyleSettings&);

/// How many pixels around a pixel its ink depends on.
[[nodiscard]] int sumiReach(const StyleSettings&);

}  // namespace inkedge
