#pragma once

#include <inkedge/settings.h>

namespace inkedge::render {

/// Whether Renderer::render() draws with OpenGL.
[[nodiscard]] bool pictureNeedsContext(const RenderSettings&);
/// Whether Renderer::lines() does.
[[nodiscard]] bool linesNeedContext(const RenderSettings&);

}  // namespace inkedge::render
