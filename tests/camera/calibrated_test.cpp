#include <limits>

#include <gmock/gmock.h>
#include <glm/matrix.hpp>

#include <inkedge/camera.h>
#include <inkedge/error.h>

#include "base/expect_error.h"
#include "camera/framed_scenes.h"
#include "scenes.h"

namespace inkedge::camera {
namespace {

using namespace framed_scenes;
using testing::HasSubstr;
using testing::StartsWith;

constexpr Size wide{640, 360};

glm::dmat3 smallK() {
    glm::dmat3 k{1.0};
    k[0][0] = k[1][1] = 500.0;
    k[2] = {300.25, 200.5, 1.0};
    return k;
}

glm::dmat4 pose() { return scenes::translation({1, -2, 8}) * scenes::rotation(25, {1, 2, 3}); }

// Where a point comes to lie, by OpenGL's matrices.
glm::dvec2 pixelOf(const Camera& camera, Size size, glm::dvec3 point) {
    const glm::dvec4 clip = camera.projection(size) * camera.view * glm::dvec4{point, 1.0};
    return {0.5 * size.width * (1.0 + clip.x / clip.w), 0.5 * size.height * (1.0 - clip.y / clip.w)};
}

TEST(CalibratedCamera, projectsAsItsMatricesSay) {
    const glm::dmat4 toWorld = pose();
    const glm::dvec3 point{0.5, -1.5, 1.0};
    for (const CameraAxes axes : {CameraAxes::OpenGl, CameraAxes::OpenCv}) {
        Camera camera = cameraFromIntrinsics(smallK(), toWorld, axes, wide);
        camera.near = 1.0;
        camera.far = 20.0;
        glm::dvec3 seen{glm::inverse(toWorld) * glm::dvec4{point, 1.0}};
        if (axes == CameraAxes::OpenGl) seen = {seen.x, -seen.y, -seen.z};
        const glm::dvec3 expected = smallK() * (seen / seen.z);
        const glm::dvec2 found = pixelOf(camera, wide, point);
        EXPECT_NEAR(found.x - 0.5, expected.x, nearlyExact);  // (0, 0) is the middle of OpenCV's first pixel
        EXPECT_NEAR(found.y - 0.5, expected.y, nearlyExact);
    }
}

TEST(CalibratedCamera, givesItsMatricesBack) {
    const Camera camera = cameraFromIntrinsics(smallK(), pose(), CameraAxes::OpenCv, wide);
    const glm::dmat3 k = camera.intrinsics(wide);
    const glm::dmat4 toWorld = glm::inverse(camera.worldToCamera());
    for (int column = 0; column < 3; ++column) expectNear(k[column], smallK()[column], nearlyExact);
    for (int column = 0; column < 4; ++column) expectNear(toWorld[column], pose()[column]);
}

TEST(CalibratedCamera, isFoundFromOpenGlsMatrices) {
    Camera perspective;
    perspective.view = glm::inverse(pose());
    perspective.viewAngle = 40.0;
    perspective.near = 0.5;
    perspective.far = 70.0;
    perspective.axis = {0.25, -0.5};
    Camera orthographic = perspective;
    orthographic.orthographicHeight = 3.0;
    for (const Camera& camera : {perspective, orthographic}) {
        const Camera found = cameraFromMatrices(camera.view, camera.projection(wide), wide);
        EXPECT_EQ(found.view, camera.view);
        EXPECT_NEAR(found.near, camera.near, nearlyExact);
        EXPECT_NEAR(found.far, camera.far, nearlyExact);
        EXPECT_EQ(found.orthographic(), camera.orthographic());
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row)
                EXPECT_NEAR(found.projection(wide)[column][row], camera.projection(wide)[column][row], nearlyExact);
        }
    }
}

TEST(CalibratedCamera, hasNoPlanesOfAnInfiniteProjection) {
    Camera camera;
    camera.near = 0.5;
    camera.far = 1.0;
    glm::dmat4 projection = camera.projection(square);
    projection[2][2] = -1.0;
    projection[3][2] = -1.0;
    const Camera found = cameraFromMatrices(camera.view, projection, square);
    EXPECT_EQ(found.near, 0.0);
    EXPECT_EQ(found.far, 0.0);
}

TEST(CalibratedCamera, refusesPixelsThatAreNoSquares) {
    glm::dmat3 k = smallK();
    k[0][0] = 500.05;  // the picture's edge moves by 0.03 pixels
    EXPECT_NO_THROW((void)cameraFromIntrinsics(k, pose(), CameraAxes::OpenCv, wide));
    k[0][0] = 501.0;
    expectError(Error::Kind::Usage,
                StartsWith("K: expected square pixels in a picture of 640 x 360, found them 1.002 times as high as "
                           "wide; "),
                [&] { (void)cameraFromIntrinsics(k, pose(), CameraAxes::OpenCv, wide); });
    expectError(Error::Kind::Usage, HasSubstr("make it for the picture's aspect"), [&] {
        (void)cameraFromMatrices(glm::dmat4{1.0}, Camera{.near = 1, .far = 2}.projection(square), wide);
    });
}

TEST(CalibratedCamera, refusesWhatIsNoSuchMatrix) {
    const auto refusesK = [](const glm::dmat3& k) {
        expectError(Error::Kind::Usage, StartsWith("K: expected the rows (fx, 0, cx), (0, fy, cy) and (0, 0, 1)"),
                    [&] { (void)cameraFromIntrinsics(k, pose(), CameraAxes::OpenCv, wide); });
    };
    glm::dmat3 k = smallK();
    k[1][0] = 0.5;  // a shear
    refusesK(k);
    refusesK(2.0 * smallK());
    refusesK(glm::transpose(smallK()));
    k = smallK();
    k[1][1] = -500.0;
    refusesK(k);
    k[1][1] = std::numeric_limits<double>::quiet_NaN();
    refusesK(k);

    const auto refusesPose = [](const glm::dmat4& wrong) {
        expectError(Error::Kind::Usage, StartsWith("pose: expected a rotation and a translation"),
                    [&] { (void)cameraFromIntrinsics(smallK(), wrong, CameraAxes::OpenCv, wide); });
    };
    refusesPose(glm::transpose(pose()));
    refusesPose(scenes::scaling({2, 2, 2}));
    refusesPose(scenes::scaling({1, 1, -1}));
    refusesPose(scenes::translation({0, std::numeric_limits<double>::infinity(), 0}));

    const glm::dmat4 projection = Camera{.near = 1, .far = 2}.projection(wide);
    for (const glm::dmat4& wrong : {glm::dmat4{1.0} - glm::dmat4{1.0}, glm::transpose(projection), -projection}) {
        expectError(Error::Kind::Usage, StartsWith("projection: expected OpenGL's, perspective or orthographic"),
                    [&] { (void)cameraFromMatrices(glm::dmat4{1.0}, wrong, wide); });
    }
    expectError(Error::Kind::Usage, StartsWith("projection: expected near and far planes that follow each other"),
                [&] { (void)cameraFromMatrices(glm::dmat4{1.0}, Camera{.near = 2, .far = 1}.projection(wide), wide); });
    expectError(Error::Kind::Usage, testing::StrEq("size: expected 1 pixel or more along each side, found 0 x 4"), [&] {
        (void)cameraFromMatrices(glm::dmat4{1.0}, projection, {0, 4});
    });
}

}  // namespace
}  // namespace inkedge::camera
