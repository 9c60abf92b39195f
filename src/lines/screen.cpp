#include "lines/screen.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace inkedge::lines {

Screen::Screen(const Camera& camera, glm::dvec3 origin, Size size)
    : size_{size},
      centre_{camera.centre(size)},
      orthographic_{camera.orthographic()},
      focalLength_{camera.focalLength(size)},
      pixelAspect_{camera.orthographic() ? 1.0 : camera.pixelAspect},
      near_{camera.near} {
    const glm::dmat4 toWorld = glm::inverse(camera.view);
    right_ = glm::normalize(glm::dvec3{toWorld[0]});
    up_ = glm::normalize(glm::dvec3{toWorld[1]});
    direction_ = -glm::normalize(glm::dvec3{toWorld[2]});
    eye_ = glm::dvec3{toWorld[3]} - origin;
}

ScreenPoint Screen::project(glm::dvec3 world) const noexcept {
    const glm::dvec3 from = world - eye_;
    const double depth = glm::dot(direction_, from);
    const double scale = orthographic_ ? focalLength_ : focalLength_ / depth;
    return {{centre_.x + scale / pixelAspect_ * glm::dot(right_, from), centre_.y - scale * glm::dot(up_, from)},
            orthographic_ ? -depth : 1.0 / depth};
}

glm::dvec3 Screen::worldAt(const ScreenPoint& p) const noexcept {
    const double depth = orthographic_ ? -p.inverseDepth : 1.0 / p.inverseDepth;
    const double scale = orthographic_ ? 1.0 / focalLength_ : depth / focalLength_;
    const glm::dvec2 centred = p.pixel - centre_;
    return eye_ + depth * direction_ + scale * (centred.x * pixelAspect_ * right_ - centred.y * up_);
}

}  // namespace inkedge::lines
