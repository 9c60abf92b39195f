#pragma once

#include <span>
#include <vector>

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "lines/border_parts.h"
#include "lines/contour_finders.h"
#include "lines/screen.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// Which lines of instances are wanted.
struct CurveChoice {
    Contour contour = Contour::Auto;
    ContourFinder finder = ContourFinder::Every;
    bool eyeOutside = true;  ///< the eye and the near plane are outside the scene: closed parts hide their backs
};

/// The contours, boundaries and creases of one instance that a camera may see.
///
/// A mesh contour is an edge between a front-facing and a back-facing face (Hertzmann 1999, section 3.2). A smooth contour crosses faces where n . (x - C), interpolated between
/// their corners, is zero (equations 2 to 4), zeros counted as plus. With Contour::Auto a patch has smooth contours if its
/// mesh contour has edges of under smoothEdge pixels in the mean: there they are within a pixel or so of the mesh's,
/// without its zigzag; larger faces are seen for what they are.
///
/// Of closed, consistently wound parts the contours that the part itself hides are left out: concave edges, and smooth
/// contours where the surface turns towards the eye; also creases between back-facing faces.
/// @param search   of the instance's mesh
/// @param memory   of the instance, for ContourFinder::Random
/// @param borders  the instance's, of findBorderParts()
void collectInstanceCurves(const Scene&, std::uint32_t instance, const ContourSearch& search, ContourMemory& memory,
                           const Screen&, const CurveChoice&, std::span<const BorderPart> borders,
                           std::vector<Segment>& to);

/// Pixels.
inline constexpr double smoothEdge = 3.0;

}  // namespace inkedge::lines
