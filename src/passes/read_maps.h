#pragma once

#include <inkedge/maps.h>

#include "passes/detect_edges.h"
#include "passes/draw_surface.h"

namespace inkedge::passes {

/// Which of the surface's maps are read.
struct SurfaceMaps {
    bool depth = false;  ///< Maps::depth and Maps::windowDepth
    bool normal = false;
};
void readSurface(const gl::Api&, const SurfaceBuffers&, SurfaceMaps, Maps&);

/// Which masks of edges are read, and their magnitudes where those are kept.
struct EdgeMaps {
    bool depth = false;
    bool normal = false;
    bool either = false;  ///< Maps::edges
};
void readEdges(const gl::Api&, const EdgeBuffers&, EdgeMaps, Maps&);

/// 255 where a pixel has any of the types, else 0.
/// @param types  as Maps::types
[[nodiscard]] Image<std::uint8_t> mask(const Image<std::uint16_t>& types, LineTypes wanted);

}  // namespace inkedge::passes
