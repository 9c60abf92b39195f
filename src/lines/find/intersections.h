#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

#include "lines/find/mesh_edges.h"
#include "scene/scene_face.h"

namespace inkedge::lines {

/// The segment along which two faces cross.
struct IntersectionSegment {
    scene::SceneFace a;
    scene::SceneFace b;              ///< after a by instance, then by triangle
    std::array<glm::dvec3, 2> ends;  ///< world space less the middle of Scene::bounds(); never equal
    /// One per end: segments of the same two instances with the same number are joined there. 0, 1, 2, ... with no
    /// number left out.
    std::array<std::uint32_t, 2> nodes;
};

/// Faces that meet at a smaller angle, in degrees, give no line: they are one surface, or layers of one.
inline constexpr double minIntersectionAngle = 15.0;

/// The lines in which faces cross, within a mesh and between instances.
///
/// Two faces cross if they have no point in common, their planes meet at more than minIntersectionAngle, and each goes
/// on to both sides of the other. Touching gives no line: a corner on a face, or an edge that lies in a face while the
/// edge's two faces stay on one side of it. An edge in another face is a line of its own if it is a crease or a border.
/// Else, if the edge's two faces lie to both sides, the edge is one segment, not two. Distances below weldTolerance of
/// the larger mesh's box count as 0, so that solids which stand on each other do not cross. Faces that repeat another
/// face of their mesh, and faces too thin for a normal, are left out. Triangles of one face of a CAD file, or of two
/// that share an edge, are not compared: FileFaces.
///
/// If very many faces all cross each other, segments beyond about ten million are left out.
///
/// Ordered by the instances of a and b, then by their triangles, whatever the number of threads. Thread-safe.
/// About O(n log n) for surfaces: the search in a tree of boxes with cones of normals skips parts that are nearly flat.
/// @param edges  one per mesh
/// @throws std::bad_alloc
[[nodiscard]] std::vector<IntersectionSegment> findIntersections(const Scene&, std::span<const MeshEdges> edges);

}  // namespace inkedge::lines
