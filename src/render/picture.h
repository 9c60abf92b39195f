#pragma once

#include <inkedge/camera.h>
#include <inkedge/maps.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "render/kept.h"

namespace inkedge::render {

/// Renderer::render() of what is known to be usable.
[[nodiscard]] Maps drawPicture(const Scene&, const Camera&, const RenderSettings&, Kept&);

}  // namespace inkedge::render
