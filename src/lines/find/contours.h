#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "lines/find/border_parts.h"
#include "lines/find/contour_finders.h"
#include "lines/find/isolines.h"
#include "lines/screen.h"
#include "lines/segment.h"
#include "mesh/control_mesh.h"

namespace inkedge::lines {

/// Which lines of instances are wanted.
struct CurveChoice {
    Contour contour = Contour::Auto;
    ContourFinder finder = ContourFinder::Every;
    int refinement = 0;                      ///< levels of subdivision near smooth contours
    const ControlMesh* control = nullptr;    ///< of the mesh; with a refinement
    HiddenLines hidden = HiddenLines::None;  ///< what a part itself hides is found only if it is wanted
    bool eyeOutside = true;  ///< the eye and the near plane are outside the scene: closed parts hide their backs
    LineTypes lines = allLineTypes;  ///< PictureSettings::lines: whether marked edges are drawn, and as what
};

/// What one instance's mesh has of its own, whatever the view.
struct InstanceEdges {
    const ContourSearch& search;               ///< the mesh's
    std::span<const BorderPart> borders;       ///< the instance's, of findBorderParts()
    std::span<const IsolineSegment> isolines;  ///< the mesh's that are wanted
};

/// The contours, boundaries, creases, marked edges and isoparametric lines of one instance that a camera may see.
///
/// A mesh contour is an edge between a front-facing and a back-facing face (Hertzmann 1999, section 3.2). A smooth
/// contour crosses faces where n . (x - C), interpolated between their corners, is zero (equations 2 to 4), zeros
/// counted as plus. With Contour::Auto a patch has smooth contours if its mesh contour has edges of under smoothEdge
/// pixels in the mean: there they are within a pixel or so of the mesh's, without its zigzag; larger faces are seen for
/// what they are.
///
/// With a refinement every patch has smooth contours, and they are those of the limit surface, found on the triangles
/// of refineNear(); all else stays on the mesh as it is.
///
/// Of closed, consistently wound parts the contours that the part itself hides are left out, or marked as hidden if
/// those are wanted: concave edges, and smooth contours where the surface turns towards the eye; also what lies within
/// or between back-facing faces.
/// @param memory  of the instance, for ContourFinder::Random
void collectInstanceCurves(const Scene&, std::uint32_t instance, const InstanceEdges&, ContourMemory& memory,
                           const Screen&, const CurveChoice&, std::vector<Segment>& to);

/// Pixels.
inline constexpr double smoothEdge = 3.0;

}  // namespace inkedge::lines
