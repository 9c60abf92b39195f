#pragma once

#include <glad/gl.h>

namespace inkedge::gl {

/// The functions of one context.
using Api = GladGLContext;

}  // namespace inkedge::gl
