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

/// What lies under the lines, as Maps::shade. RenderSettings::shade is not Shade::None.
/// @param times  those of its stages are added
/// @throws Error  (Kind::Context, Kind::Runtime) as Renderer
[[nodiscard]] Image<std::uint8_t> shadeOf(const Scene&, const Camera&, const RenderSettings&, Kept&,
                                          std::vector<StageTime>& times);

/// Whether a scene has lines or edges that are drawn as LineType::Marked.
[[nodiscard]] bool hasMarked(const Scene&);

/// Whether a scene has edges that are drawn as LineType::Tangent.
[[nodiscard]] bool hasTangent(const Scene&);

/// The lines of lines::typesBesidePixels that are seen: no pixels show them, so that image space has them from object
/// space. None where that needs a module that is not there: renderWarnings() says so.
/// @throws Error  as lines::ObjectLines
[[nodiscard]] Lines linesBesidePixels(const Scene&, const Camera&, const RenderSettings&, Kept&);

/// The lines that the planes detector finds between pixels, as polylines, and linesBesidePixels().
/// @throws Error  (Kind::Usage) if another detector is asked for; (Kind::Context, Kind::Runtime) as Renderer
[[nodiscard]] Lines imageLines(const Scene&, const Camera&, const RenderSettings&, Kept&);

}  // namespace inkedge::render
