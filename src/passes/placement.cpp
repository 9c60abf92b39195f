#include "passes/placement.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "camera/stands_outside.h"

namespace inkedge {
namespace {

void storeRows(const glm::dmat4& matrix, glm::vec4 (&rows)[3]) {
    const glm::dmat4 transposed = glm::transpose(matrix);
    for (int row = 0; row < 3; ++row) rows[row] = glm::vec4{transposed[row]};
}

// Inverse transpose up to a positive factor, which also exists where a scale is zero: the cofactors, whose sign a
// mirror turns round.
glm::dmat3 normalMatrix(const glm::dmat3& m) {
    const glm::dmat3 cofactors{glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) largest = std::max(largest, glm::length(cofactors[column]));
    const double sign = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    return largest > 0.0 ? cofactors * (sign / largest) : cofactors;
}

}  // namespace

double unitLength(const Scene& scene) { return scene.bounds().radius > 0.0 ? scene.bounds().radius : 1.0; }

glm::dmat4 reversedProjection(const Camera& camera, Size size, double unit) {
    Camera scaled = camera;
    scaled.near /= unit;
    scaled.far /= unit;
    scaled.orthographicHeight /= unit;
    glm::dmat4 reverse{1.0};
    reverse[2][2] = -0.5;
    reverse[3][2] = 0.5;
    return reverse * scaled.projection(size);
}

gl::UploadedScene::HiddenBacks hiddenBacks(const Scene& scene, const Camera& camera) {
    return standsOutside(camera, scene) ? gl::UploadedScene::HiddenBacks::Skip : gl::UploadedScene::HiddenBacks::Draw;
}

std::vector<gl::UploadedScene::PlacedInstance> placeInstances(const Scene& scene, const gl::UploadedScene& upload,
                                                              const Camera& camera, LightSpace lightSpace) {
    glm::dmat4 scale{1.0 / unitLength(scene)};
    scale[3][3] = 1.0;
    std::vector<gl::UploadedScene::PlacedInstance> placements;
    placements.reserve(upload.instanceOrder().size());
    for (const std::uint32_t i : upload.instanceOrder()) {
        const Instance& instance = scene.instances()[i];
        glm::dmat4 fromOrigin{1.0};
        fromOrigin[3] = glm::dvec4{scene.meshes()[instance.mesh].origin, 1.0};
        const glm::dmat4 modelView = scale * camera.view * instance.transform * fromOrigin;
        auto& placed = placements.emplace_back();
        storeRows(modelView, placed.modelView);
        const glm::dmat4& lit = lightSpace == LightSpace::World ? instance.transform : modelView;
        storeRows(glm::dmat4{normalMatrix(glm::dmat3{lit})}, placed.normalMatrix);
    }
    return placements;
}

}  // namespace inkedge
