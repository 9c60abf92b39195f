#pragma once

#include <inkedge/image.h>

#include "gl/function_inputs.h"
#include "passes/frame.h"

namespace inkedge::passes {

/// Lines by polygons that are added to the model's in one pass: Detector::RaskarCohen. Shaders: draw_fattened.vert,
/// .geom and .frag; CPU definition: reference::drawFattened().
/// @param frame  in samples
/// @param width  samples
/// @return       255 where a sample of what the tile draws is inked, else 0
[[nodiscard]] Image<std::uint8_t> drawFattened(const Frame& frame, gl::FunctionInputs&, double width);

}  // namespace inkedge::passes
