#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <inkedge/face_surfaces.h>

namespace inkedge::mesh {

/// A point of a surface x(u, v), with its first two derivatives.
struct SurfaceDerivatives {
    glm::dvec3 position{0.0};
    glm::dvec3 du{0.0};
    glm::dvec3 dv{0.0};
    glm::dvec3 duu{0.0};
    glm::dvec3 duv{0.0};
    glm::dvec3 dvv{0.0};
};

/// Its normal is x_u x x_v.
[[nodiscard]] inline SurfacePoint surfacePoint(const SurfaceDerivatives& d) {
    return {.position = d.position,
            .du = d.du,
            .dv = d.dv,
            .normal = glm::cross(d.du, d.dv),
            .normalDu = glm::cross(d.duu, d.dv) + glm::cross(d.du, d.duv),
            .normalDv = glm::cross(d.duv, d.dv) + glm::cross(d.du, d.dvv)};
}

}  // namespace inkedge::mesh
