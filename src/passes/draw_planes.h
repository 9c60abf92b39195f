#pragma once

#include <inkedge/settings.h>

#include "passes/draw_surface.h"
#include "passes/frame.h"

namespace inkedge::passes {

/// The plane and the patch that each pixel sees. Row 0 is the tile's top row.
struct PlaneBuffers {
    /// RGBA32F: w, dw/dx and dw/dy per pixel, and the patch. w is 1 / eye-space depth or, in an orthographic view,
    /// - eye-space depth; lengths are in unit lengths. The last channel is 2^48 times the patch's number or, of
    ///   coplanar
    /// layers, the sum of the numbers of those that overlap. On the background it is 0, and the others have no meaning.
    gl::Texture planes;
    gl::Texture triangles;  ///< R32UI: 1 + the scene's triangle; background 0
};

/// Draws the scene once, and its coplanar layers once more. Shaders: draw_planes.vert, draw_planes.frag.
[[nodiscard]] PlaneBuffers drawPlanes(const Frame&);

/// What drawPlanes() and drawSurface() with NormalLights::Single give, from one pass over the triangles.
struct PlanesAndSurface {
    PlaneBuffers planes;
    SurfaceBuffers surface;
};
[[nodiscard]] PlanesAndSurface drawPlanesAndSurface(const Frame&, LightSpace);

}  // namespace inkedge::passes
