#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

#include "scene/scene_face.h"

namespace inkedge {

/// Where two faces cross.
struct IntersectionSegment {
    SceneFace a;
    SceneFace b;                         ///< greater than a by instance, then by triangle
    std::array<glm::dvec3, 2> ends;      ///< world space less the middle of Scene::bounds(); apart from each other
    std::array<std::uint32_t, 2> nodes;  ///< one an end: segments of the same two instances that share a number go on
                                         ///< into each other there; 0, 1, 2, ... with no number left out
};

/// Faces that meet at less than this, in degrees, give no line: they are one surface, or layers of one.
inline constexpr double leastIntersectionAngle = 15.0;

/// The lines in which faces cross, within a mesh and between instances.
///
/// Faces cross where they have no point in common, their planes meet at more than leastIntersectionAngle, and each goes
/// on to both sides of the other. What only touches gives no line: a corner on a face, and an edge that lies in a face
/// whose two faces stay on one side of it. An edge in another face is a line of its own where it is a crease or a
/// border; else, where its two faces lie to both sides, it is one segment, not two. Distances below weldTolerance of
/// the larger mesh's box are none, so that parts which stand on each other do not cross. Faces that repeat another one
/// of their mesh and faces too thin for a normal take no part.
///
/// In a soup of faces that all cross each other, what is beyond some ten million segments is left out.
///
/// Ordered by the instances of a and b, then by their triangles, whatever the number of threads. Thread-safe.
/// About O(n log n) for surfaces: a tree of boxes with cones of normals passes over what is nearly flat.
/// @throws std::bad_alloc
[[nodiscard]] std::vector<IntersectionSegment> findIntersections(const Scene&);

}  // namespace inkedge
