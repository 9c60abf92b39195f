#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "lines/find/border_segments.h"
#include "lines/find/contour_finders.h"
#include "lines/find/isolines.h"
#include "lines/screen.h"
#include "lines/segment.h"
#include "mesh/limit_surfaces.h"

namespace inkedge::lines {

/// What marked edges are that are creases, too.
enum class MarkedCreases { AreMarked, AreCreasesIfDrawn };

/// Which lines of instances to find.
struct CurveChoice {
    Contour contour = Contour::Auto;
    ContourFinder finder = ContourFinder::Every;
    int refinement = 0;                          ///< levels of subdivision near smooth contours
    const mesh::LimitSurfaces* limit = nullptr;  ///< of the mesh; with a refinement
    /// None: lines that a closed component itself hides are not found.
    HiddenLines hidden = HiddenLines::None;
    bool eyeOutside = true;  ///< the eye and the near plane are outside the scene: closed components hide their backs
    LineTypes lines = standardLineTypes;  ///< PictureSettings::lines: whether marked edges are drawn, and as what
    MarkedCreases markedCreases = MarkedCreases::AreMarked;
};

/// The edges of one instance that do not depend on the view.
struct InstanceEdges {
    const ContourSearch& search;               ///< of the mesh
    std::span<const BorderSegment> borders;    ///< of the instance, from findBorderSegments()
    std::span<const IsolineSegment> isolines;  ///< of the mesh, for the steps of the settings
};

/// The contours, boundaries, creases, marked edges and isoparametric lines of one instance that a camera may see.
///
/// A mesh contour is an edge between a front-facing and a back-facing face (Hertzmann 1999, section 3.2), or along the
/// near side of a face that is seen edge-on. A smooth contour crosses faces where n . (x - C), interpolated between
/// their corners, is zero (equations 2 to 4); zero counts as the far side. With Contour::Auto a patch has smooth
/// contours if the edges of its mesh contour are under smoothEdge pixels long in the mean. Smooth contours then lie
/// within about a pixel of the mesh contours, without their zigzag; on patches with larger faces, and on single faces
/// with an edge over largeEdge, the mesh contours are drawn.
///
/// With a refinement every patch has smooth contours. They are those of the limit surface, found on the triangles of
/// refineNear(). All other lines are those of the mesh.
///
/// On closed, consistently wound components some lines are hidden by the component itself: contours at concave edges,
/// smooth contours where the surface turns towards the eye, and lines within or between back-facing faces. A face seen
/// edge-on hides its edges on the far side. All these are left out, or marked as hidden if hidden lines are drawn.
/// @param memory  of the instance, for ContourFinder::Random
void collectInstanceCurves(const Scene&, std::uint32_t instance, const InstanceEdges&, ContourMemory& memory,
                           const Screen&, const CurveChoice&, std::vector<Segment>& to);

/// The mean length of contour edges under which contours are smooth, pixels.
inline constexpr double smoothEdge = 3.0;
/// The length of a face's longest edge over which the mesh contour is drawn all the same, pixels.
inline constexpr double largeEdge = 4.0 * smoothEdge;

}  // namespace inkedge::lines
