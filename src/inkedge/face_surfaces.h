#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace inkedge {

struct Mesh;

/// A point of a surface x(u, v), with its derivatives. Mesh space; Mesh::origin is not taken off.
struct SurfacePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 du{0.0};
    glm::dvec3 dv{0.0};
    glm::dvec3 normal{0.0};    ///< across du and dv, of any length, to either side; 0 where there is none
    glm::dvec3 normalDu{0.0};  ///< the normal's derivatives
    glm::dvec3 normalDv{0.0};
};

/// The part of a surface that a triangle stands for.
struct SurfaceTriangle {
    std::uint32_t face = 0;  ///< whose surface it is
    /// Parameters of the corners. One that is NaN says nothing: at a pole all values of it are one point.
    std::array<glm::dvec3, 3> corners{};
};

/// The smooth surfaces that the triangles of a mesh stand for: those of a CAD file's faces, of an equation, or the
/// limit of subdivision. Safe to ask from several threads.
class FaceSurfaces {
public:
    virtual ~FaceSurfaces() = default;

    /// What a triangle of the mesh stands for. None: that is not known.
    [[nodiscard]] virtual std::optional<SurfaceTriangle> under(const Mesh&, std::uint32_t triangle) const = 0;

    /// A point of a surface; beyond the border of the face it goes on.
    /// @param parameters  what varies linearly over a triangle to reach all of its surface: u and v first, or a
    ///                    position that the surface is near
    [[nodiscard]] virtual SurfacePoint at(std::uint32_t face, glm::dvec3 parameters) const = 0;

    /// The parameters of a point a step from another one.
    /// @param point  at(parameters)
    /// @param step   of u and v
    [[nodiscard]] virtual glm::dvec3 moved(glm::dvec3 parameters, const SurfacePoint& point, glm::dvec2 step) const {
        static_cast<void>(point);
        return parameters + glm::dvec3{step, 0.0};
    }
};

}  // namespace inkedge
