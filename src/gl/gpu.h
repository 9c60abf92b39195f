#pragma once

#include "gl/context.h"
#include "gl/programs.h"
#include "gl/textures.h"

namespace inkedge::gl {

/// What a pass draws with: a context, which is current, its programs and its textures.
struct Gpu {
    explicit Gpu(const Api& functions) : api{functions}, programs{functions}, textures{functions} {}

    const Api& api;
    Programs programs;
    TexturePool textures;
    VertexArray emptyVertices = createVertexArray(api);  // a core profile draws nothing without a vertex array
};

}  // namespace inkedge::gl
