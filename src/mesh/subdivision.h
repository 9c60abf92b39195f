#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/control_mesh.h"
#include "mesh/surface_point.h"
#include "modules/open_module.h"

// The interface between the library and the subdivision module. OpenSubdiv brings OpenMP along; a module keeps both
// from slowing the start of those who do not subdivide.

namespace inkedge::mesh {

/// A smooth surface, sampled: faces of three corners under Loop, of four under Catmull-Clark.
struct RefinedFaces {
    std::vector<glm::dvec3> positions;   ///< one per vertex: on the limit surface
    std::vector<glm::dvec3> normals;     ///< one per vertex: unit, of the limit surface; vertices are split at creases
    std::vector<std::uint32_t> corners;  ///< into vertices, face after face
    std::vector<std::uint32_t> parents;  ///< one per face: the control face that the face comes from; ascending
    std::vector<bool> creases;           ///< one per corner: whether the edge from it to the next is sharp
    /// One per corner, if the control mesh has any: linear across control faces, so that seams stay where they are.
    std::vector<glm::vec2> coordinates;
    std::vector<VertexPaint> paint;  ///< as coordinates
    /// One per corner, if the control mesh has any: the kinds of the control edge that the edge from this corner to the
    /// next is a part of.
    std::vector<EdgeKinds> edges;
    std::string failure;
};

/// The smooth surface itself. Safe to ask from several threads.
class LimitSurface {
public:
    virtual ~LimitSurface() = default;

    /// Beyond the face it goes on as a parabola does.
    /// @param quad  under Catmull-Clark, of a face that is no quad: the corner whose quad u and v are of; else 0
    [[nodiscard]] virtual SurfaceDerivatives at(std::uint32_t face, std::uint32_t quad, glm::dvec2 uv) const = 0;
};
struct MadeLimitSurface {
    std::shared_ptr<const LimitSurface> surface;
    std::string failure;
};

/// The module's functions; safe to call from several threads.
struct Subdivision {
    /// @param levels  1 to 6: each makes four faces of one; the first one of Catmull-Clark n faces of one with n
    ///                corners
    RefinedFaces (*refine)(const ControlMesh&, int levels);
    MadeLimitSurface (*limit)(const ControlMesh&);
};

inline constexpr modules::ModuleOf<Subdivision> subdivisionModule{{.purpose = "subdivision",
                                                                   .file = "inkedge_subdivision.so",
                                                                   .symbol = "inkedge_subdivision_5",
                                                                   .library = "OpenSubdiv",
                                                                   .option = "INKEDGE_OPENSUBDIV",
                                                                   .remedy = "leave subdivision out"}};

}  // namespace inkedge::mesh
