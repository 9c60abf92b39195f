#pragma once

#include "gl/api.h"

namespace inkedge::passes {

/// Sets what draw_function.vert reads of vertices without an attribute.
inline void setMissingAttributes(const gl::Api& api) {
    api.VertexAttrib2f(10, 0.0F, 0.0F);
    api.VertexAttrib4f(11, 1.0F, 1.0F, 1.0F, 1.0F);
    api.VertexAttrib2f(12, 0.0F, 0.0F);
    api.VertexAttrib1f(13, 0.0F);
}

}  // namespace inkedge::passes
