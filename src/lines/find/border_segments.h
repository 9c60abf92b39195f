#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

#include "lines/find/mesh_edges.h"
#include "scene/scene_face.h"

namespace inkedge::lines {

/// A straight piece of a mesh's border: a border edge, or a part of one.
struct BorderSegment {
    std::uint32_t instance;
    std::uint32_t halfEdge;
    double from;  ///< shares of the edge's length
    double to;
    scene::SceneFace other{~0U, 0};  ///< the face on the other side, where the surface goes on; none: the surface ends
    /// With another face: a point of that face off the edge, world space less the centre of the bounds.
    glm::dvec3 otherInner{0.0};
    bool bends = false;   ///< with another face: whether the faces meet in a crease
    bool marked = false;  ///< whether the file marks the edge of either face
};

/// The borders of all instances, divided where other borders run along them. Two surfaces that touch are one surface,
/// and the seam between them is no border. The stretch that two borders share is listed for the first of them only.
/// Ordered by instance and half-edge. O(b log b + pairs of borders that are near each other).
[[nodiscard]] std::vector<BorderSegment> findBorderSegments(const Scene&, std::span<const MeshEdges> meshes);

}  // namespace inkedge::lines
