#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <inkedge/face_surfaces.h>

#include "lines/segment.h"

namespace inkedge::lines {

/// A triangle for the search of smooth contours, in mesh space less Mesh::origin.
struct Facet {
    std::uint32_t face;  ///< of the mesh, that the triangle is or lies on
    double size;         ///< how far off the mesh the triangle may lie
    std::array<glm::dvec3, 3> corners{};
    std::array<double, 3> viewDots{};          ///< n . (x - C) at the corners
    std::array<Key, 3> edges{};                ///< the names of the edges from each corner to the next
    std::optional<SurfaceTriangle> surface{};  ///< that it stands for

    [[nodiscard]] glm::dvec3 normal() const {
        return glm::cross(corners[1] - corners[0], corners[2] - corners[0]);  // of any length
    }

    /// The view dot of the triangle's plane.
    /// @param normals  the sum of the corners' normals: the plane's normal is taken to be on their side
    /// @param view     from the eye to the first corner
    [[nodiscard]] double planeViewDot(glm::dvec3 normals, glm::dvec3 view) const {
        return glm::dot(normal(), view) * (glm::dot(normal(), normals) < 0.0 ? -1.0 : 1.0);
    }

    /// How fast the view dot grows away from the eye; over 0 or below.
    /// @param view  from the eye to the first corner
    [[nodiscard]] double growthAlong(glm::dvec3 view) const {
        const glm::dvec3 u = corners[1] - corners[0];
        const glm::dvec3 v = corners[2] - corners[0];
        const glm::dvec3 gradient = glm::cross(v, normal()) * (viewDots[1] - viewDots[0]) +
                                    glm::cross(normal(), u) * (viewDots[2] - viewDots[0]);
        return glm::dot(gradient, view);
    }

    /// The sign that a view dot of 0 counts as on a surface that does not hide its backs: what is seen edge-on lies to
    /// the far side of a contour, if the triangle lies nearer.
    /// @param view  from the eye to the first corner
    [[nodiscard]] int signOfZero(glm::dvec3 view) const {
        const auto [low, high] = std::minmax({viewDots[0], viewDots[1], viewDots[2]});
        if (low < 0.0 && high > 0.0) return 1;
        const int own = high > 0.0 ? 1 : -1;
        return growthAlong(view) * own < 0.0 ? -own : own;
    }
};

}  // namespace inkedge::lines
