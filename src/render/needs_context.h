#pragma once

#include <inkedge/settings.h>

namespace inkedge::render {

/// Whether Renderer::render() draws with OpenGL.
[[nodiscard]] bool pictureNeedsContext(const RenderSettings&);
/// Whether Renderer::lines() does.
[[nodiscard]] bool linesNeedContext(const RenderSettings&);

/// Whether Renderer::render() finds lines on the mesh, which takes rays, whatever the scene holds.
[[nodiscard]] bool pictureNeedsRays(const RenderSettings&);
/// Opens what casts rays, if it is there: loading it takes as long as finding the lines of a small part.
void openRays();

}  // namespace inkedge::render
