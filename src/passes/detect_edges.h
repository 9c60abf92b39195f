#pragma once

#include <optional>

#include <inkedge/camera.h>

#include "gl/gpu.h"
#include "passes/edge_marks.h"

namespace inkedge::passes {

/// The edges of a picture. Row 0 is the picture's top row.
struct EdgeBuffers {
    Size size;                              ///< of the picture
    gl::Texture marks;                      ///< R32UI, as EdgeMarks::blocks
    std::optional<gl::Texture> magnitudes;  ///< RG32F: of the depth map; of the normal map, the largest of its channels
};

enum class Magnitudes { Drop, Keep };

/// Edges of the depth map and of the normal map (appendix A, equations 5 to 8). Shaders: detect_edges.frag for the
/// marks, measure_edges.frag for the magnitudes; CPU definition: reference::detectEdges(), which it equals except where
/// a magnitude is within float rounding of its threshold.
/// @param surface  as SurfaceBuffers::surface; left unchanged
[[nodiscard]] EdgeBuffers detectEdges(gl::Gpu&, const gl::Texture& surface, const Camera&, const DetectorSettings&,
                                      Magnitudes);

[[nodiscard]] EdgeMarks readMarks(const gl::Api&, const EdgeBuffers&);

}  // namespace inkedge::passes
