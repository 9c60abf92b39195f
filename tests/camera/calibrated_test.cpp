#include <limits>

#include <gmock/gmock.h>
#include <glm/matrix.hpp>

#include <inkedge/camera.h>
#include <inkedge/error.h>

#include "base/expect_error.h"
#include "camera/framed_scenes.h"
#include "raster/plane_pairs.h"
#include "scenes.h"

namespace inkedge::camera {
namespace {

using namespace framed_scenes;
using testing::HasSubstr;
using testing::StartsWith;

constexpr Size wide{640, 360};

glm::dmat3 smallK() {
    glm::dmat3 k{1.0};
    k[0][0] = 520.0;
    k[1][1] = 500.0;
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

// Bends are measured between normals that are read off pixels: lines of pixels that are no squares lie where those of
// squares do.
TEST(CalibratedCamera, givesPlanesTheirNormalsWhateverItsPixels) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3{0.3, -0.4, 0.8});
    for (const double focalX : {250.0, 500.0, 1000.0}) {
        glm::dmat3 k = smallK();
        k[0][0] = focalX;
        const Camera camera = cameraFromIntrinsics(k, glm::dmat4{1.0}, CameraAxes::OpenGl, wide);
        // 1 / depth where the ray of a pixel meets the plane n . p = -5.
        const auto inverseDepth = [&](glm::dvec2 pixel) {
            const glm::dvec2 fromCentre = pixel - camera.centre(wide);
            const glm::dvec3 ray{fromCentre.x / k[0][0], -fromCentre.y / k[1][1], -1.0};
            return glm::dot(normal, ray) / -5.0;
        };
        const glm::dvec2 at{400.5, 100.5};
        const double w = inverseDepth(at);
        const glm::dvec2 slope{inverseDepth(at + glm::dvec2{1, 0}) - w, inverseDepth(at + glm::dvec2{0, 1}) - w};
        const glm::dvec3 found = glm::normalize(raster::normalOf(
            {w, slope, 1.0, at - camera.centre(wide)}, {camera.focalLengths(wide), camera.orthographic(), 0.8}));
        expectNear(glm::dvec3{-found.x, found.y, found.z}, normal);  // x and y count along the picture's axes
    }
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

TEST(CalibratedCamera, refusesAProjectionForAPictureOfAnotherShape) {
    Camera camera{.near = 1, .far = 2, .pixelAspect = 1.01};
    EXPECT_NEAR(cameraFromMatrices(glm::dmat4{1.0}, camera.projection(wide), wide).pixelAspect, 1.01, nearlyExact);
    expectError(
        Error::Kind::Usage,
        StartsWith("projection: expected one for a picture of 640 x 360, found one whose pixels are 0.5625 "
                   "times as wide as high there; make it for the picture's aspect"),
        [&] { (void)cameraFromMatrices(glm::dmat4{1.0}, Camera{.near = 1, .far = 2}.projection(square), wide); });
    camera.orthographicHeight = 3.0;
    glm::dmat4 stretched = camera.projection(wide);
    stretched[0][0] *= 1.001;
    expectError(Error::Kind::Usage, HasSubstr("make it for the picture's aspect"),
                [&] { (void)cameraFromMatrices(glm::dmat4{1.0}, stretched, wide); });
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
