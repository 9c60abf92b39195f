#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/camera.h>
#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "ink/stroke.h"
#include "raster/samples.h"
#include "raster/tiles.h"
#include "trace/screen_triangles.h"

namespace inkedge {

/// The buffers of a tile that lines are traced in, in samples: one per pixel, or 2 x 2 or 4 x 4. Row 0 is the tile's
/// top row.
struct LineBuffers {
    Tile tile;
    Samples<float> planes;  ///< as PlaneBuffers::planes; needed in the regionsAround() the marks
    /// As PlaneBuffers::triangles; needed in the regionsAround() the marks, everywhere for TraceIds::Keep.
    Samples<std::uint32_t> triangles;
    Image<std::uint8_t> marks;  ///< as detectLines() returns them
};

/// The surface on which a stroke lies: the nearer one of the two sides of its line.
struct StrokeSurface {
    float inverseDepthFrom;  ///< at the stroke's ends: ScreenTriangles::Plane::w
    float inverseDepthTo;
    std::uint32_t triangle;  ///< 1 + the scene's triangle
};

struct TracedLines {
    std::vector<Stroke> strokes;          ///< in output pixels of the whole picture: of cells that the tile keeps
    std::vector<StrokeSurface> surfaces;  ///< one per stroke; empty for TraceSurfaces::Drop
    Image<std::uint16_t> types;           ///< as Maps::types, of the kept part of the tile
    Image<std::uint32_t> ids;             ///< as Maps::ids, of the kept part of the tile; empty for TraceIds::Drop
};

enum class TraceIds { Drop, Keep };
enum class TraceSurfaces { Drop, Keep };

/// Which types of lines become strokes, and which of them have a pen of their own. A stroke is drawn with the pen of
/// the first of its types that has a pen of its own, else with that of its first type.
struct DrawnTypes {
    LineTypes drawn;
    LineTypes withPens;
};
[[nodiscard]] DrawnTypes drawnTypes(const PictureSettings&);

/// Traces lines between samples. A line crosses the step between two neighbouring samples exactly where the planes meet
/// or the nearer surface ends. The crossings around each cell of 2 x 2 samples are joined by strokes.
/// @param triangles       as the camera projects them onto the whole picture's samples
/// @param unit            scene units in a unit length of the planes
/// @param types           the types that become strokes; the maps hold all types
[[nodiscard]] TracedLines traceLines(LineBuffers, const Scene&, const ScreenTriangles& triangles, const Camera&,
                                     double unit, DrawnTypes types, int samplesPerPixel, TraceIds, TraceSurfaces);

}  // namespace inkedge
