#pragma once

#include <vector>

#include <inkedge/settings.h>

#include "gl/function_inputs.h"
#include "passes/edge_marks.h"
#include "passes/frame.h"

namespace inkedge::passes {

/// The edges of a function, equation 7: R32UI, EdgeMarks::functionEdge, packed as EdgeMarks::blocks. Shader:
/// detect_function.frag.
/// @param values  as drawFunction() returns them
[[nodiscard]] gl::Texture detectFunction(gl::Gpu&, const gl::Texture& values, const FunctionSettings&);

/// Gradient magnitude of a function's values, equation 6, R32F: bit for bit what detectFunction() compares. Shader:
/// measure_function.frag; CPU definition: reference::functionMagnitude().
/// @param values  as drawFunction() returns them
[[nodiscard]] gl::Texture measureFunction(gl::Gpu&, const gl::Texture& values, const FunctionSettings&);

/// How much of each pixel the edges of any of the functions cover, equation 7: 0 to 255. The functions are drawn one
/// after the other.
/// @param frame    in samples
/// @param samples  a pixel, along each axis
/// @throws Error   as drawFunction()
[[nodiscard]] Image<std::uint8_t> functionEdges(const Frame& frame, gl::FunctionInputs&,
                                                const std::vector<FunctionSettings>&, int samples);

}  // namespace inkedge::passes
