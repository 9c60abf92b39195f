#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/image.h>

#include "lines/screen.h"
#include "lines/see/surface_parts.h"
#include "raster/samples.h"
#include "scene/scene_face.h"

namespace inkedge::lines {

/// What a camera sees, pixel by pixel, as the image-space passes draw it.
struct ViewBuffers {
    Samples<float> planes;                      ///< as PlaneBuffers::planes
    Samples<std::uint32_t> triangles;           ///< as PlaneBuffers::triangles
    std::vector<std::uint32_t> firstTriangles;  ///< for each instance the number of its first triangle in the scene
    double unit = 1.0;                          ///< scene units in a unit length of the planes
};

/// What the pixels around a place of a line say of it.
enum class Guess { Seen, Hidden, Unsure };

/// Looks at a place's pixel and at those 0.75 pixels to either side of the line. A pixel does not hide the place if it
/// shows the background or one of the line's own faces, or if the plane that it shows, at the pixel and at the place,
/// is not nearer by over 0.1 pixels across and the slack. Places are seen if no pixel hides them, hidden if all do.
/// @param across  unit, across the line in the picture
/// @param slack   pixels across: how much nearer what hides the place must be
[[nodiscard]] Guess guessVisibility(const ViewBuffers&, const Screen&, const ScreenPoint&, glm::dvec2 across,
                                    std::span<const SceneFace> own, const Slack& slack);

/// Whether the pixel that a place lies in shows the background; what lies beyond the picture does not.
[[nodiscard]] bool isBackground(const ViewBuffers&, glm::dvec2 place);

}  // namespace inkedge::lines
