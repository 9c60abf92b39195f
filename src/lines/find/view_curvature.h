#pragma once

#include <glm/vec3.hpp>

#include "mesh/surface_form.h"

namespace inkedge::lines {

/// How a surface bends along the view. Lengths are counted in the surface's feature size, as in PointForm.
struct RadialCurvature {
    double cosine;      ///< of the angle between the normal and the way to the eye; under 0: seen from behind
    double sine;        ///< of that angle
    double curvature;   ///< along the projection w of that way onto the surface: 0 on suggestive contours
    double torsion;     ///< how much the normal turns aside along w
    double derivative;  ///< of the curvature tensor: its component along w, three times
};

/// @param toEye  from the point to the eye, of any length over 0
[[nodiscard]] RadialCurvature radialCurvature(const mesh::PointForm&, glm::dvec3 toEye);

/// How fast the radial curvature grows towards the eye where it is 0: over 0 on suggestive contours. Of a surface that
/// is seen from behind, which is the same as one turned over.
/// Source: DeCarlo et al. 2003, section 3.1, and 2004, section 3.
[[nodiscard]] double growthTowardsEye(const RadialCurvature&);

/// The curvature that the eye sees: how far the normal turns per length in the picture, in the direction in which it
/// turns the furthest. Source: Judd et al. 2007, section 3.
struct ApparentCurvature {
    double cosine;     ///< as RadialCurvature::cosine, but never under 0
    double curvature;  ///< 0 or more
    /// Unit, tangent: over which the normal turns the furthest in the picture.
    glm::dvec3 direction;
    double derivative;  ///< of the curvature, per length in the picture along the direction
};

/// @param toEye  from the point to the eye, in feature sizes
[[nodiscard]] ApparentCurvature apparentCurvature(const mesh::PointForm&, glm::dvec3 toEye, bool orthographic);

}  // namespace inkedge::lines
