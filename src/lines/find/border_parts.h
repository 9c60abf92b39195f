#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

#include "lines/find/mesh_edges.h"
#include "scene/scene_face.h"

namespace inkedge::lines {

/// A part of a mesh's border.
struct BorderPart {
    std::uint32_t instance;
    std::uint32_t halfEdge;
    double from;  ///< shares of the edge's length
    double to;
    SceneFace other{~0U, 0};     ///< the face that goes on across it; none: the surface ends
    glm::dvec3 otherInner{0.0};  ///< with another face: a point of it off the edge, world less the centre of the bounds
    bool bends = false;          ///< with another face: by more than the crease angle
    bool marked = false;         ///< whether the file marks it, on either face
};

/// The borders of all instances, parted where other borders run along them: parts that touch each other are one
/// surface, and its seam is no border. What two borders share is named by the first of them only.
/// Ordered by instance and half-edge. O(b log b + pairs of borders that are near each other).
[[nodiscard]] std::vector<BorderPart> findBorderParts(const Scene&, std::span<const MeshEdges> meshes);

}  // namespace inkedge::lines
