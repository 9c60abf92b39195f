#pragma once

#include <inkedge/camera.h>

#include "gl/gpu.h"

namespace inkedge::passes {

/// The normal map of section 2.1.2 from its two passes: positive light minus negative light, both RGBA8, with eye-space
/// depth from the reversed depth buffer. Returns RGBA32F as SurfaceBuffers::surface. Each channel of a normal is within
/// half a step of 8 bits (1/510) of the unit normal's. Shader: combine_lights.frag.
[[nodiscard]] gl::Texture combineLights(gl::Gpu&, const gl::Texture& positive, const gl::Texture& negative,
                                        const gl::Texture& depth, const Camera&);

}  // namespace inkedge::passes
