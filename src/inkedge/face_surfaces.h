#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace inkedge {

/// A point of a surface x(u, v), with its derivatives. Mesh space; Mesh::origin is not taken off.
struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 du{0.0};
    glm::dvec3 dv{0.0};
    glm::dvec3 duu{0.0};
    glm::dvec3 duv{0.0};
    glm::dvec3 dvv{0.0};
};

/// The surfaces of the faces of a mesh, as CAD files have them. Safe to ask from several threads.
class FaceSurfaces {
public:
    virtual ~FaceSurfaces() = default;

    /// Whether the surface of a face is known. Faces are numbered as in Mesh::faces.
    [[nodiscard]] virtual bool knows(std::uint32_t face) const noexcept = 0;

    /// The surface of a face that is known; beyond the face's border it goes on.
    /// @param parameters  (u, v), as Mesh::parameters has them
    [[nodiscard]] virtual SurfacePoint at(std::uint32_t face, glm::dvec2 parameters) const = 0;
};

}  // namespace inkedge
