#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/export.h>

#include "mesh/control_mesh.h"

// What the library and the subdivision module say to each other (modules/open_module.h). Failures come back as text of
// one line, empty where there is none.

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

/// The module's one symbol. Its number rises with every change in this file or in ControlMesh, so that a module of
/// another build is refused instead of misread.
extern "C" INKEDGE_API const Subdivision* inkedge_subdivision_4() noexcept;
inline constexpr char subdivisionSymbol[] = "inkedge_subdivision_4";
inline constexpr char subdivisionFile[] = "inkedge_subdivision.so";

/// Opens the module on first use.
/// @throws Error  (Kind::Runtime) if it is not there, or if inkedge was built without it
[[nodiscard]] const Subdivision& subdivision();

}  // namespace inkedge
