#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include <inkedge/face_surfaces.h>
#include <inkedge/mesh.h>

#include "mesh/control_mesh.h"

namespace inkedge::mesh {

class LimitSurface;

/// The smooth surface that a control mesh stands for: the limit of subdivision. Its faces are the control mesh's; their
/// parameters are u, v and, of a polygon that is no quad under Catmull-Clark, which of its quads they are of: each
/// corner has one, in which u runs along the edge to the next corner.
class LimitSurfaces : public FaceSurfaces {
public:
    /// @param levels  of the triangles that stand for it: subdivideMeshes()
    /// @param origin  of the mesh, which the control mesh is less of
    LimitSurfaces(ControlMesh control, int levels, glm::dvec3 origin);

    [[nodiscard]] const ControlMesh& control() const { return control_; }
    [[nodiscard]] int levels() const { return levels_; }

    /// What a triangle stands for, by its number: they are numbered face by face.
    [[nodiscard]] SurfaceTriangle triangle(std::uint32_t number) const;
    [[nodiscard]] std::optional<SurfaceTriangle> under(const Mesh&, std::uint32_t triangle) const override;

    /// @throws Error  (Kind::Runtime) if the subdivision module is missing
    [[nodiscard]] SurfacePoint at(std::uint32_t face, glm::dvec3 parameters) const override;

private:
    ControlMesh control_;
    int levels_;
    glm::dvec3 origin_;
    std::vector<std::uint32_t> firstTriangles_;  // one per face
    mutable std::once_flag isMade_;
    mutable std::shared_ptr<const LimitSurface> surface_;  // made on first use
};

/// The number of the first triangle that each face of a control mesh is divided into.
[[nodiscard]] std::vector<std::uint32_t> trianglesOfFaces(const ControlMesh&, int levels);

}  // namespace inkedge::mesh
