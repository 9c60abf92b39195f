#include <inkedge/camera.h>

#include <cmath>

#include <glm/trigonometric.hpp>

namespace inkedge {

glm::dmat4 Camera::projection(Size size) const noexcept {
    const double aspect = static_cast<double>(size.width) / size.height;
    glm::dmat4 p{0.0};
    if (orthographic()) {
        p[1][1] = 2.0 / orthographicHeight;
        p[2][2] = -2.0 / (far - near);
        p[3][2] = -(far + near) / (far - near);
        p[3][3] = 1.0;
        p[3][0] = axis.x;
        p[3][1] = axis.y;
    } else {
        p[1][1] = 1.0 / std::tan(glm::radians(viewAngle) / 2.0);
        p[2][2] = -(far + near) / (far - near);
        p[2][3] = -1.0;
        p[3][2] = -2.0 * far * near / (far - near);
        p[2][0] = -axis.x;
        p[2][1] = -axis.y;
    }
    p[0][0] = p[1][1] / (aspect * (orthographic() ? 1.0 : pixelAspect));
    return p;
}

glm::dvec2 Camera::centre(Size size) const noexcept {
    return {0.5 * size.width * (1.0 + axis.x), 0.5 * size.height * (1.0 - axis.y)};
}

double Camera::focalLength(Size size) const noexcept { return 0.5 * size.height * projection(size)[1][1]; }

glm::dvec2 Camera::focalLengths(Size size) const noexcept {
    const double upwards = focalLength(size);
    return {orthographic() ? upwards : upwards / pixelAspect, upwards};
}

glm::dmat4 Camera::worldToCamera() const noexcept {
    glm::dmat4 turned{1.0};
    turned[1][1] = turned[2][2] = -1.0;
    return turned * view;
}

glm::dmat3 Camera::intrinsics(Size size) const noexcept {
    const glm::dvec2 middle = centre(size);
    glm::dmat3 k{1.0};
    const glm::dvec2 focal = focalLengths(size);
    k[0][0] = focal.x;
    k[1][1] = focal.y;
    k[2][0] = middle.x - 0.5;
    k[2][1] = middle.y - 0.5;
    return k;
}

}  // namespace inkedge
