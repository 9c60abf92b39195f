#pragma once

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>
#include <glm/matrix.hpp>

#include <inkedge/camera.h>
#include <inkedge/error.h>

#include "base/expect_error.h"
#include "scenes.h"

namespace inkedge::framed_scenes {

inline constexpr Size square{100, 100};
inline constexpr double frameShare = 0.92;  // what a framed model fills of the picture's tighter side

// Matrices of doubles with entries of order 1: a few roundings of 1e-16 each.
inline constexpr double exact = 1e-12;
// After division by a depth, and vertices that went through float.
inline constexpr double nearlyExact = 1e-9;

// Nothing symmetric: the picture's centre, the bounds' centre and the origin all differ.
inline Scene skewScene(double scale = 1.0) {
    const auto grow = scenes::scaling(glm::dvec3{scale});
    return scenes::sceneOf(
        {{scenes::box({4, 1, 2}), grow * scenes::translation({3, 1, -2})},
         {scenes::cube(0.5), grow * scenes::translation({0, 3, 1}) * scenes::rotation(40, {1, 2, 3})}});
}

inline glm::dvec3 position(const Camera& camera) { return glm::dvec3{glm::inverse(camera.view)[3]}; }
inline glm::dvec3 worldAxis(const Camera& camera, int axis) { return glm::transpose(glm::dmat3{camera.view})[axis]; }
inline glm::dvec3 forward(const Camera& camera) { return -worldAxis(camera, 2); }
inline double depthOf(const Camera& camera, glm::dvec3 point) { return -(camera.view * glm::dvec4{point, 1.0}).z; }

inline void expectNear(glm::dvec3 found, glm::dvec3 expected, double tolerance = exact) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
}

struct Frame {
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};
};

// What the model covers, in normalised device coordinates.
inline Frame covered(const Scene& scene, const Camera& camera, Size size) {
    Frame frame;
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) {
        const glm::dvec2 ndc{scenes::project(camera, size, p)};
        frame.low = glm::min(frame.low, ndc);
        frame.high = glm::max(frame.high, ndc);
    }
    return frame;
}

inline void expectFramed(const Scene& scene, const Camera& camera, Size size) {
    const Frame frame = covered(scene, camera, size);
    const double widest = std::max({-frame.low.x, -frame.low.y, frame.high.x, frame.high.y});
    EXPECT_NEAR(widest, frameShare, nearlyExact) << "the model fills the frame and no more";
    for (int axis = 0; axis < 2; ++axis) {
        if (std::max(-frame.low[axis], frame.high[axis]) < frameShare - nearlyExact) continue;
        EXPECT_NEAR(frame.low[axis], -frame.high[axis], nearlyExact) << "equal margins on the tighter side";
    }
}

inline void expectVerticesBetweenNearAndFar(const Scene& scene, const Camera& camera) {
    for (const glm::dvec3& p : scenes::drawnVertices(scene)) {
        EXPECT_GT(depthOf(camera, p), camera.near);
        EXPECT_LT(depthOf(camera, p), camera.far);
    }
}

inline void expectRefusal(const CameraSettings& wanted, const std::string& message) {
    expectError(Error::Kind::Usage, testing::StrEq(message), [&] { (void)frameCamera(skewScene(), wanted, square); });
}

inline Scene sceneWithCameras() {
    Scene::Data data;
    data.meshes.push_back(scenes::cube());
    data.instances.push_back({"cube", 0, glm::dmat4{1.0}});
    data.cameras.push_back({"ahead", scenes::translation({0, 0, 9}), 50.0, 0.0});
    data.cameras.push_back({"side", scenes::translation({7, 0, 0}) * scenes::rotation(90, {0, 1, 0}), 35.0, 4.0});
    return Scene{data};
}

}  // namespace inkedge::framed_scenes
