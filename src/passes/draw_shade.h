#pragma once

#include <glm/vec3.hpp>

#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "gl/function_inputs.h"
#include "passes/frame.h"

namespace inkedge::passes {

/// What lies under the lines of a tile. Shaders: draw_function.vert, draw_shade.frag; CPU definition:
/// reference::drawShade().
/// @param frame         in samples
/// @param shade         but Shade::None
/// @param towardsLight  view space, unit length
/// @param samples       a pixel, along each axis
/// @return              4 channels, as Maps::shade, one value a pixel of what the tile draws
[[nodiscard]] Image<std::uint8_t> drawShade(const Frame& frame, gl::FunctionInputs&, Shade shade,
                                            glm::dvec3 towardsLight, int samples);

}  // namespace inkedge::passes
