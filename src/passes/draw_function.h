#pragma once

#include <inkedge/surface_functions.h>

#include "gl/function_inputs.h"
#include "passes/frame.h"

namespace inkedge::passes {

/// The values of a surface function: Hertzmann 1999, section 2.1.3. Shaders: draw_function.vert, draw_function.frag and
/// one of shaders/functions, or a user's file. CPU definition: reference::drawFunction().
/// @return        RGBA32F of the size of what the tile draws; the background's last channel is over 1e29 where the
///                function has no value there
/// @throws Error  (Kind::Input) if the scene has no texture coordinates and the function needs them, or a file of it
///                cannot be read or, a shader, is refused: the message names file and line
[[nodiscard]] gl::Texture drawFunction(const Frame&, gl::FunctionInputs&, const FunctionSettings&);

}  // namespace inkedge::passes
