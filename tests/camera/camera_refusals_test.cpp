#include <gmock/gmock.h>

#include <inkedge/camera.h>
#include <inkedge/error.h>

#include "base/expect_error.h"
#include "camera/framed_scenes.h"
#include "scenes.h"

namespace inkedge::camera {
namespace {

using namespace framed_scenes;
using testing::StrEq;

TEST(FrameCamera, refusesACameraThatTheFileDoesNotHave) {
    CameraSettings wanted;
    wanted.index = 2;
    expectError(Error::Kind::Usage, StrEq("--camera-index: expected a camera of the file, 0 to below 2, found 2"),
                [&] { (void)frameCamera(sceneWithCameras(), wanted, square); });
    wanted.index = -1;
    expectError(Error::Kind::Usage, StrEq("camera-index: expected a whole number from 0, found '-1'"),
                [&] { (void)frameCamera(sceneWithCameras(), wanted, square); });
}

TEST(FrameCamera, refusesTwoWaysToSayOneThing) {
    const glm::dvec3 v{1, 2, 3};
    CameraSettings wanted;
    wanted.azimuthAngle = 10.0;
    wanted.direction = v;
    expectRefusal(wanted, "--camera-direction: expected it without an azimuth or elevation angle, found both");
    wanted = {};
    wanted.elevationAngle = 10.0;
    wanted.direction = v;
    expectRefusal(wanted, "--camera-direction: expected it without an azimuth or elevation angle, found both");
    wanted = {};
    wanted.elevationAngle = 10.0;
    wanted.position = v;
    expectRefusal(wanted, "--camera-position: expected it without an azimuth or elevation angle, found both");
    wanted = {};
    wanted.position = v;
    wanted.direction = v;
    wanted.focalPoint = v;
    expectRefusal(
        wanted, "--camera-direction: expected it without both --camera-position and --camera-focal-point, found both");
    for (int which = 0; which < 7; ++which) {
        wanted = {};
        wanted.index = 0;
        if (which == 0) wanted.position = v;
        if (which == 1) wanted.focalPoint = v;
        if (which == 2) wanted.direction = v;
        if (which == 3) wanted.viewUp = v;
        if (which == 4) wanted.azimuthAngle = 1.0;
        if (which == 5) wanted.elevationAngle = 1.0;
        if (which == 6) wanted.view = NamedView::Top;
        expectRefusal(wanted, "--camera-index: expected it without another camera position or direction, found both");
    }
    for (int which = 0; which < 4; ++which) {
        wanted = {};
        wanted.view = NamedView::Front;
        if (which == 0) wanted.position = v;
        if (which == 1) wanted.direction = v;
        if (which == 2) wanted.azimuthAngle = 1.0;
        if (which == 3) wanted.elevationAngle = 1.0;
        expectRefusal(wanted, "--view: expected it without another camera position or direction, found both");
    }
}

TEST(FrameCamera, refusesACameraInsideOut) {
    CameraSettings wanted;
    wanted.position = glm::dvec3{1, 2, 3};
    wanted.focalPoint = glm::dvec3{1, 2, 3};
    expectRefusal(wanted, "--camera-position: expected a place other than the focal point, found both at 1,2,3");
    wanted = {};
    wanted.direction = glm::dvec3{0.0};
    expectRefusal(wanted, "--camera-direction: expected a direction, found 0,0,0");
    wanted.position = glm::dvec3{1, 2, 3};
    expectRefusal(wanted, "--camera-direction: expected a direction, found 0,0,0");
    wanted = {};
    wanted.viewUp = glm::dvec3{0.0};
    expectRefusal(wanted, "--camera-view-up: expected a direction, found 0,0,0");
    wanted = {};
    wanted.direction = glm::dvec3{0, 0, -2};
    wanted.viewUp = glm::dvec3{0, 0, 3};
    expectRefusal(wanted,
                  "--camera-view-up: expected a direction across the view direction 0,0,-1, found one along it");
}

TEST(FrameCamera, refusesNumbersOutOfRange) {
    CameraSettings wanted;
    wanted.viewAngle = 0.0;
    expectRefusal(wanted, "camera-view-angle: expected a number from 0.001 to 179, found '0'");
    wanted.viewAngle = 180.0;
    expectRefusal(wanted, "camera-view-angle: expected a number from 0.001 to 179, found '180'");
    wanted = {};
    wanted.zoomFactor = 0.0;
    expectRefusal(wanted, "camera-zoom-factor: expected a number from 0.001 to 1000000, found '0'");
    wanted.zoomFactor = -2.0;
    expectRefusal(wanted, "camera-zoom-factor: expected a number from 0.001 to 1000000, found '-2'");
    wanted = {};
    wanted.orthographicHeight = -1.0;
    expectRefusal(wanted, "camera-orthographic: expected 0 or a number from 1e-36 to 1e+36, found '-1'");
}

}  // namespace
}  // namespace inkedge::camera
