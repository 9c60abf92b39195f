#pragma once

#include <optional>

#include <inkedge/camera.h>

#include "gl/gpu.h"

namespace inkedge {

/// Where the edges are. Row 0 is the picture's top row.
struct EdgeBuffers {
    static constexpr unsigned depthEdge = 1;  ///< bits of marks
    static constexpr unsigned normalEdge = 2;
    gl::Texture marks;                      ///< R8UI
    std::optional<gl::Texture> magnitudes;  ///< RG32F: of the depth map; of the normal map, the largest of its channels
};

enum class Magnitudes { Drop, Keep };

/// Edges of the depth map and of the normal map (appendix A, equations 5 to 8). Shader: detect_edges.frag; CPU
/// definition: reference::detectEdges(), which it equals except where a magnitude is within float rounding of its
/// threshold.
/// @param surface  as SurfaceBuffers::surface; left unchanged
[[nodiscard]] EdgeBuffers detectEdges(gl::Gpu&, const gl::Texture& surface, const Camera&, const DetectorSettings&,
                                      Magnitudes);

}  // namespace inkedge
