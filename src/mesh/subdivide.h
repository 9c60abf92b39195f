#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include <inkedge/mesh.h>
#include <inkedge/settings.h>

#include "mesh/control_mesh.h"

namespace inkedge::mesh {

/// Replaces every mesh by triangles whose vertices lie on the smooth surface that the mesh controls, settings.subdivide
/// levels down: of Loop's scheme, or of Catmull-Clark's where the file had polygons. Creases (over the crease angle, or
/// by the file's normals) and borders stay sharp. Faces keep their material, their number and their order. Normals are
/// those of the limit surface. Texture coordinates and paint are linear across the faces before refinement. The parts
/// of an edge keep its kinds. Triangles that repeat an earlier one or have collapsed are dropped. A mesh without faces
/// stays as it is.
/// @throws Error  (Kind::Input) if vertices and indices would come to more than settings.limits.vertices;
///                (Kind::Runtime) if the subdivision module is missing
void subdivideMeshes(std::vector<Mesh>&, const LoadSettings& settings);

enum class Projection { Perspective, Orthographic };

/// The smooth surface near its contour.
struct RefinedContourMesh {
    std::vector<glm::dvec3> positions;   ///< one per vertex: on the limit surface; mesh space, less origin
    std::vector<glm::dvec3> normals;     ///< one per vertex: unit, the limit surface's; split at creases
    std::vector<std::uint32_t> indices;  ///< three per triangle
    /// One per triangle: the first triangle of the mesh's face that the triangle lies on.
    std::vector<std::uint32_t> controlTriangles;
    /// One per triangle: its number in LimitSurfaces of so many levels.
    std::vector<std::uint32_t> limitTriangles;
};

/// Refines the faces of a mesh that may hold a contour: those with a sign change in their control mesh, which is the
/// face and all faces that share a vertex with it (Hertzmann 1999, section 3.3). The sign is that of n . (x - C), zero
/// counts as plus (equations 2 and 3). It is taken of the shading normals at corners and of the normals of the
/// triangles. Where the triangles' signs all agree the control mesh is one-to-one in the picture, so that the surface
/// has no contour.
///
/// The triangles are those that subdivideMeshes() makes of the same faces, within rounding. Of other faces nothing is
/// returned: their limit surface has no contour. Meant for a mesh that was not subdivided when it was loaded: a
/// subdivided mesh would be taken as a control mesh again, which smooths it twice.
/// @param mesh     with all its normals
/// @param control  controlMesh() of the mesh: depends on no view, so one serves all
/// @param eye      where the camera stands, mesh space; orthographic: its direction into the scene, of any length
/// @param levels   1 to 6
/// @throws Error   (Kind::Runtime) if the subdivision module is missing or memory runs out
/// Thread-safe. O(faces of the mesh + triangles returned).
[[nodiscard]] RefinedContourMesh refineNear(const Mesh& mesh, const ControlMesh& control, const glm::dvec3& eye,
                                            Projection, int levels);

}  // namespace inkedge::mesh
