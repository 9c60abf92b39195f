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

/// What the detector left for the ink, in samples: one a pixel, or 2 x 2 or 4 x 4. Row 0 is the tile's top row.
struct LineBuffers {
    Tile tile;                         ///< what they show
    Samples<float> planes;             ///< as PlaneBuffers::planes; needed where regionsAround() the marks are
    Samples<std::uint32_t> triangles;  ///< as PlaneBuffers::triangles; likewise, everywhere for TraceIds::Keep
    Image<std::uint8_t> marks;         ///< as detectLines() returns them
};

/// Where a stroke lies in the scene.
struct StrokePlace {
    float nearnessFrom;  ///< of the nearer surface at the stroke's ends: ScreenTriangles::Plane::w
    float nearnessTo;
    std::uint32_t triangle;  ///< of it: 1 + the scene's triangle
};

struct TracedLines {
    std::vector<Stroke> strokes;      ///< in output pixels of the whole picture: those of cells that the tile keeps
    std::vector<StrokePlace> places;  ///< one a stroke; empty unless asked for
    Image<std::uint16_t> types;       ///< as Maps::types, of what the tile keeps
    Image<std::uint32_t> ids;         ///< as Maps::ids, likewise; empty unless asked for
};

enum class TraceIds { Drop, Keep };
enum class TracePlaces { Drop, Keep };

/// Which types of lines become strokes, and which of them have a style of their own. A stroke has the style of the
/// first of its types that has one, else of its first.
struct DrawnTypes {
    LineTypes drawn;
    LineTypes styled;
};
[[nodiscard]] DrawnTypes drawnTypes(const PictureSettings&);

/// Places each crossing between two neighbouring samples exactly where the planes meet or the nearer surface ends,
/// finds out what it is, and joins the crossings around each cell of 2 x 2 samples by strokes.
/// @param triangles       as the camera projects them onto the whole picture's samples
/// @param unit            scene units in a unit length of the planes
/// @param types           what becomes strokes; the maps hold all
[[nodiscard]] TracedLines traceLines(LineBuffers, const Scene&, const ScreenTriangles& triangles, const Camera&,
                                     double unit, DrawnTypes types, int samplesPerPixel, TraceIds, TracePlaces);

}  // namespace inkedge
