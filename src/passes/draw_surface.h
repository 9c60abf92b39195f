#pragma once

#include <inkedge/settings.h>

#include "passes/frame.h"

namespace inkedge::passes {

/// The visible surface, for later passes. Row 0 is the tile's top row.
struct SurfaceBuffers {
    /// RGBA32F: unit normal in the lights' space, turned to the side that is seen; eye-space depth in scene units.
    /// Background: 0, 0, 0, camera.far.
    gl::Texture surface;
    gl::Texture depth;  ///< DEPTH_COMPONENT32F, reversed: 1 at near, 0 at far and on the background
};

/// Depth map and normal map in one pass over the triangles, or in the paper's two (sections 2.1.1 and 2.1.2).
/// Shaders: draw_surface.vert, draw_surface.frag, combine_lights.frag.
[[nodiscard]] SurfaceBuffers drawSurface(const Frame&, const DetectorSettings&);

}  // namespace inkedge::passes
