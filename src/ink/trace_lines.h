#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/camera.h>
#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "ink/paint_strokes.h"

namespace inkedge {

/// What the detector left for the ink, in samples: one a pixel, or 2 x 2 or 4 x 4. Row 0 is the top row.
struct LineBuffers {
    Image<float> planes;             ///< as PlaneBuffers::planes
    Image<std::uint32_t> triangles;  ///< as PlaneBuffers::triangles
    Image<std::uint8_t> marks;       ///< as detectLines() returns them
};

struct TracedLines {
    std::vector<Stroke> strokes;  ///< in output pixels
    Image<std::uint8_t> types;    ///< as Maps::types
    Image<std::uint32_t> ids;     ///< as Maps::ids; empty unless asked for
};

enum class TraceIds { Drop, Keep };

/// Which types of lines become strokes, and which of them have a style of their own: bits of LineType. A stroke has the
/// style of the first of its types that has one, else of its first.
struct DrawnTypes {
    std::uint8_t drawn;
    std::uint8_t styled;
};
[[nodiscard]] DrawnTypes drawnTypes(const PictureSettings&);

/// Places each crossing between two neighbouring samples exactly where the planes meet or the nearer surface ends,
/// finds out what it is, and joins the crossings around each cell of 2 x 2 samples by strokes.
/// @param firstTriangles  for each instance the number of its first triangle in the scene
/// @param unit            scene units in a unit length of the planes
/// @param types           what becomes strokes; the maps hold all
[[nodiscard]] TracedLines traceLines(LineBuffers, const Scene&, const std::vector<std::uint32_t>& firstTriangles,
                                     const Camera&, double unit, DrawnTypes types, int samplesPerPixel, TraceIds);

}  // namespace inkedge
