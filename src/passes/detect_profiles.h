#pragma once

#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "passes/frame.h"

namespace inkedge::passes {

/// Profiles and internal edges after Saito and Takahashi 1990: how dark each pixel is, 0 to 255. Shader:
/// detect_profiles.frag; CPU definition: reference::detectProfiles().
/// @param frame    in pixels
/// @param surface  as SurfaceBuffers::surface; left unchanged
[[nodiscard]] Image<std::uint8_t> detectProfiles(const Frame& frame, const gl::Texture& surface,
                                                 const DetectorSettings&);

}  // namespace inkedge::passes
