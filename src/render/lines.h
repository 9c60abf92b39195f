#pragma once

#include <inkedge/camera.h>
#include <inkedge/lines.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "render/kept.h"

namespace inkedge::render {

/// The lines of the mesh itself.
/// @throws Error  as lines::ObjectLines
[[nodiscard]] Lines objectLines(const Scene&, const Camera&, const RenderSettings&, Kept&);

/// The lines that the planes detector finds between pixels, as polylines.
/// @throws Error  (Kind::Usage) if another detector is asked for; (Kind::Context, Kind::Runtime) as Renderer
[[nodiscard]] Lines imageLines(const Scene&, const Camera&, const RenderSettings&, Kept&);

}  // namespace inkedge::render
