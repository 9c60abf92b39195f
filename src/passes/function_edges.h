#pragma once

#include <vector>

#include <inkedge/settings.h>

#include "gl/function_inputs.h"
#include "passes/edge_marks.h"
#include "passes/frame.h"

namespace inkedge {

/// Where a function has an edge, equation 7: R32UI, EdgeMarks::functionEdge in what EdgeMarks::blocks holds. Shader:
/// detect_function.frag.
/// @param values  as drawFunction() returns them
[[nodiscard]] gl::Texture detectFunction(gl::Gpu&, const gl::Texture& values, const FunctionSettings&);

/// Gradient magnitude of a function's values, equation 6, R32F: what detectFunction() compares, bit for bit. Shader:
/// measure_function.frag; CPU definition: reference::functionMagnitude().
/// @param values  as drawFunction() returns them
[[nodiscard]] gl::Texture measureFunction(gl::Gpu&, const gl::Texture& values, const FunctionSettings&);

/// Where any of the functions has an edge, equation 7: how much of each pixel, 0 to 255. The functions are drawn one
/// after the other.
/// @param frame    in samples
/// @param samples  a pixel, along each axis
/// @throws Error   as drawFunction()
[[nodiscard]] Image<std::uint8_t> functionEdges(const Frame& frame, gl::FunctionInputs&,
                                                const std::vector<FunctionSettings>&, int samples);

}  // namespace inkedge
