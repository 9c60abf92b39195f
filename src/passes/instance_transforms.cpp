#include "passes/instance_transforms.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace inkedge::passes {
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

std::vector<gl::UploadedScene::InstanceTransforms> instanceTransforms(const Frame& frame, LightSpace lightSpace) {
    const Scene& scene = frame.scene;
    const std::vector<std::uint32_t>& order = frame.upload.instanceOrder();
    glm::dmat4 scale{1.0 / frame.unit};
    scale[3][3] = 1.0;
    std::vector<gl::UploadedScene::InstanceTransforms> transforms;
    transforms.reserve(order.size());
    for (const std::uint32_t i : order) {
        const Instance& instance = scene.instances()[i];
        glm::dmat4 fromOrigin{1.0};
        fromOrigin[3] = glm::dvec4{scene.meshes()[instance.mesh].origin, 1.0};
        const glm::dmat4 modelView = scale * frame.camera.view * instance.transform * fromOrigin;
        auto& transform = transforms.emplace_back();
        storeRows(modelView, transform.modelView);
        const glm::dmat4& lit = lightSpace == LightSpace::World ? instance.transform : modelView;
        storeRows(glm::dmat4{normalMatrix(glm::dmat3{lit})}, transform.normalMatrix);
    }
    return transforms;
}

}  // namespace inkedge::passes
