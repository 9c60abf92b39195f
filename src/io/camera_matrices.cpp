#include "io/camera_matrices.h"

namespace inkedge::io {

glm::dmat4 worldToCamera(const Camera& camera) {
    glm::dmat4 turned{1.0};
    turned[1][1] = turned[2][2] = -1.0;
    return turned * camera.view;
}

glm::dmat3 intrinsics(const Camera& camera, Size size) {
    const double focal = camera.focalLength(size);
    const glm::dvec2 centre = camera.centre(size);
    glm::dmat3 k{1.0};
    k[0][0] = k[1][1] = focal;
    k[2][0] = centre.x - 0.5;
    k[2][1] = centre.y - 0.5;
    return k;
}

}  // namespace inkedge::io
