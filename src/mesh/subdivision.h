#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mesh/control_mesh.h"
#include "modules/open_module.h"

// What the library and the module of subdivision say to each other. OpenSubdiv brings OpenMP along; only those who
// subdivide wait for both.

namespace inkedge {

/// A smooth surface, sampled: faces of three corners under Loop, of four under Catmull-Clark.
struct RefinedFaces {
    std::vector<glm::dvec3> positions;   ///< one a vertex: on the limit surface
    std::vector<glm::dvec3> normals;     ///< one a vertex: unit, of the limit surface; vertices are split at creases
    std::vector<std::uint32_t> corners;  ///< into vertices, face after face
    std::vector<std::uint32_t> parents;  ///< one a face: the control face that it comes from; ascends
    std::vector<bool> creases;           ///< one a corner: whether the edge from it to the next is sharp
    /// One a corner, if the control mesh has any: linear across its faces, so that seams stay where they are.
    std::vector<glm::vec2> coordinates;
    std::vector<VertexPaint> paint;  ///< likewise
    /// One a corner, if the control mesh has any: what the edge is that the edge from it to the next is a part of.
    std::vector<EdgeKinds> edges;
    std::string failure;
};

/// The module's functions; safe to call from several threads.
struct Subdivision {
    /// @param levels  1 to 6: each makes four faces of one, but the first, under Catmull-Clark, n of one with n corners
    RefinedFaces (*refine)(const ControlMesh&, int levels);
};

inline constexpr ModuleOf<Subdivision> subdivisionModule{{.purpose = "subdivision",
                                                          .file = "inkedge_subdivision.so",
                                                          .symbol = "inkedge_subdivision_4",
                                                          .library = "OpenSubdiv",
                                                          .option = "INKEDGE_OPENSUBDIV",
                                                          .remedy = "leave subdivision out"}};

}  // namespace inkedge
