#pragma once

#include <inkedge/camera.h>
#include <inkedge/settings.h>

#include "gl/gpu.h"
#include "raster/tiles.h"

namespace inkedge {

/// Profiles and internal edges after Saito and Takahashi 1990: how dark each pixel is, 0 to 255. Shader:
/// detect_profiles.frag; CPU definition: reference::detectProfiles().
/// @param surface  as SurfaceBuffers::surface; left unchanged
/// @param tile     in pixels
[[nodiscard]] Image<std::uint8_t> detectProfiles(gl::Gpu&, const gl::Texture& surface, const Camera&,
                                                 const DetectorSettings&, const Tile& tile);

}  // namespace inkedge
