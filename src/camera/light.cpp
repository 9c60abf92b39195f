#include "camera/light.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/trigonometric.hpp>

namespace inkedge::camera {

glm::dvec3 towardsLight(const Scene& scene, const Camera& camera, LightDirection light, LightSpace space) {
    const double azimuth = glm::radians(light.azimuth);
    const double elevation = glm::radians(light.elevation);
    const glm::dvec3 turned{std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                            std::cos(azimuth) * std::cos(elevation)};
    if (space == LightSpace::Camera) return turned;
    const glm::dvec3 up = scene.up();
    const glm::dvec3 front = scene.front();
    const glm::dvec3 right = glm::cross(up, front);
    return glm::normalize(glm::dmat3{camera.view} * (turned.x * right + turned.y * up + turned.z * front));
}

}  // namespace inkedge::camera
