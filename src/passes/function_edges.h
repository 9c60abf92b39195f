#pragma once

#include <inkedge/camera.h>
#include <inkedge/settings.h>

#include "gl/function_inputs.h"
#include "gl/gpu.h"
#include "gl/upload.h"
#include "tiles.h"

namespace inkedge {

/// Gradient magnitude of a function's values, equation 6, R32F. Shader: measure_function.frag; CPU definition:
/// reference::functionMagnitude().
/// @param values  as drawFunction() returns them
[[nodiscard]] gl::Texture measureFunction(gl::Gpu&, const gl::Texture& values, const FunctionSettings&);

/// Where any of the functions has an edge, equation 7: how much of each pixel, 0 to 255. The functions are drawn one
/// after the other.
/// @param tile     in samples
/// @param samples  a pixel, along each axis
/// @throws Error   as drawFunction()
[[nodiscard]] Image<std::uint8_t> functionEdges(gl::Gpu&, const gl::UploadedScene&, gl::FunctionInputs&, const Scene&,
                                                const Camera&, const std::vector<FunctionSettings>&, const Tile& tile,
                                                int samples);

}  // namespace inkedge
