#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/image.h>
#include <inkedge/scene.h>

#include "scene/scene_face.h"
#include "trace/screen_triangles.h"

namespace inkedge::trace {

/// A stretch, up to a pixel long, of a part that is thinner than a pixel in the picture: of a wire, or of a plate seen
/// from its edge. Samples see it here and there only, or nowhere. Coordinates are samples of the whole picture.
struct ThinStretch {
    std::array<glm::dvec2, 2> ends;   ///< of the line in its middle
    glm::dvec2 across;                ///< unit, from the contour that it was found at to the opposite one
    std::array<double, 2> thickness;  ///< at the ends: over 0, up to a pixel
    scene::SceneFace face;            ///< at the contour, on the side that is seen
    ScreenTriangles::Plane plane;     ///< of the face, at the contour
    bool atBorder;                    ///< whether the mesh ends on either side
};

/// Finds the thin parts of a scene, seen or hidden: looks from each contour and border of the mesh across the surface
/// for the opposite one. O(n), and a walk for every four pixels of contour.
/// @param samples  of the whole picture
[[nodiscard]] std::vector<ThinStretch> findThinParts(const Scene&, const ScreenTriangles&, Size samples,
                                                     int samplesPerPixel);

}  // namespace inkedge::trace
