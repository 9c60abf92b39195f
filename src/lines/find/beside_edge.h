#pragma once

#include <array>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace inkedge::lines {

/// Where a face lies at one of its edges in the picture.
struct BesideEdge {
    int side;             ///< -1 or 1; 0: the face is seen edge-on
    bool covers = false;  ///< the face is seen edge-on and lies before the edge: the face hides the edge
};

/// @param inner   a point of the face off the edge
/// @param view    from the eye to the edge
/// @param edgeOn  whether the face is seen edge-on
[[nodiscard]] inline BesideEdge besideEdge(const std::array<glm::dvec3, 2>& edge, glm::dvec3 inner, glm::dvec3 view,
                                           bool edgeOn) {
    const glm::dvec3 along = edge[1] - edge[0];
    const glm::dvec3 into = inner - edge[0];
    if (!edgeOn) return {glm::dot(glm::cross(along, view), into) > 0.0 ? 1 : -1};
    return {0, glm::dot(into - glm::dot(into, along) / glm::dot(along, along) * along, view) < 0.0};
}

}  // namespace inkedge::lines
