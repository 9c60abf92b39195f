#include "formats/gltf/cameras.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace inkedge::gltf {

glm::dmat4 rigid(const glm::dmat4& transform) {
    const auto unitOr = [](const glm::dvec3& v, const glm::dvec3& otherwise) {
        const double length = glm::length(v);
        return length > 0.0 ? v / length : otherwise;
    };
    const glm::dvec3 z = unitOr(glm::dvec3{transform[2]}, {0, 0, 1});
    const glm::dvec3 across = std::abs(z.y) < 0.9 ? glm::dvec3{0, 1, 0} : glm::dvec3{1, 0, 0};
    const glm::dvec3 x = unitOr(glm::cross(glm::dvec3{transform[1]}, z), glm::normalize(glm::cross(across, z)));
    return {glm::dvec4{x, 0}, glm::dvec4{glm::cross(z, x), 0}, glm::dvec4{z, 0}, transform[3]};
}

std::optional<std::string> readLens(const tinygltf::Camera& source, SceneCamera& camera) {
    if (source.type == "perspective") {
        camera.viewAngle = source.perspective.yfov * 180.0 / std::numbers::pi;
        if (camera.viewAngle > 0.0 && camera.viewAngle < 180.0) return {};
        return fmt::format("a yfov between 0 and pi, found {}", source.perspective.yfov);
    }
    camera.orthographicHeight = 2.0 * source.orthographic.ymag;
    if (camera.orthographicHeight > 0.0 && std::isfinite(camera.orthographicHeight)) return {};
    return fmt::format("a ymag over 0, found {}", source.orthographic.ymag);
}

}  // namespace inkedge::gltf
