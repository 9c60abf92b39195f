#pragma once

#include <array>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/image.h>
#include <inkedge/scene.h>

#include "scene/scene_face.h"
#include "trace/screen_triangles.h"

namespace inkedge::trace {

/// A stretch, up to a pixel long, of what is thinner than a pixel in the picture: a part, as a wire or a plate seen
/// from its edge, or a gap, as a slit in a leaf. Samples see it, or through it, here and there only, or nowhere.
/// Coordinates are samples of the whole picture.
struct ThinStretch {
    std::array<glm::dvec2, 2> ends;   ///< of the line in its middle
    glm::dvec2 across;                ///< unit, from the contour that it was found at to the opposite one
    std::array<double, 2> thickness;  ///< at the ends: over 0, up to a pixel; of a gap up to maxGap
    scene::SceneFace face;            ///< at the contour, on the side that is seen
    ScreenTriangles::Plane plane;     ///< of the face, at the contour
    bool atBorder;                    ///< whether the mesh ends on either side
    bool isGap = false;               ///< between two borders of a mesh; minGap to maxGap wide
};

/// Pixels. What is closer are cracks: vertices that nearly touch. What is farther apart no diagonal passes between
/// samples that share a side.
inline constexpr double minGap = 0.1;
inline constexpr double maxGap = 1.4143;

/// Finds the thin parts and gaps of a scene, seen or hidden: looks from each contour and border of the mesh across the
/// surface, and from borders away from it, for the opposite one. O(n), and a walk for every four pixels of contour.
/// @param samples  of the whole picture
[[nodiscard]] std::vector<ThinStretch> findThinParts(const Scene&, const ScreenTriangles&, Size samples,
                                                     int samplesPerPixel);

}  // namespace inkedge::trace
