#include <gmock/gmock.h>

#include <inkedge/camera.h>
#include <inkedge/error.h>

#include "base/expect_error.h"
#include "camera/framed_scenes.h"
#include "scenes.h"

namespace inkedge {
namespace {

using namespace framed_scenes;
using testing::StrEq;

TEST(FrameCamera, refusesACameraThatTheFileDoesNotHave) {
    CameraSettings wish;
    wish.index = 2;
    expectError(Error::Kind::Usage, StrEq("camera-index: expected a camera of the file, 0 to below 2, found 2"),
                [&] { (void)frameCamera(sceneWithCameras(), wish, square); });
    wish.index = -1;
    expectError(Error::Kind::Usage, StrEq("camera-index: expected a whole number from 0, found '-1'"),
                [&] { (void)frameCamera(sceneWithCameras(), wish, square); });
}

TEST(FrameCamera, refusesTwoWaysToSayOneThing) {
    const glm::dvec3 v{1, 2, 3};
    CameraSettings wish;
    wish.azimuthAngle = 10.0;
    wish.direction = v;
    expectRefusal(wish, "camera-direction: expected it without an azimuth or elevation angle, found both");
    wish = {};
    wish.elevationAngle = 10.0;
    wish.direction = v;
    expectRefusal(wish, "camera-direction: expected it without an azimuth or elevation angle, found both");
    wish = {};
    wish.elevationAngle = 10.0;
    wish.position = v;
    expectRefusal(wish, "camera-position: expected it without an azimuth or elevation angle, found both");
    wish = {};
    wish.position = v;
    wish.direction = v;
    wish.focalPoint = v;
    expectRefusal(wish,
                  "camera-direction: expected it without both camera-position and camera-focal-point, found both");
    for (int which = 0; which < 6; ++which) {
        wish = {};
        wish.index = 0;
        if (which == 0) wish.position = v;
        if (which == 1) wish.focalPoint = v;
        if (which == 2) wish.direction = v;
        if (which == 3) wish.viewUp = v;
        if (which == 4) wish.azimuthAngle = 1.0;
        if (which == 5) wish.elevationAngle = 1.0;
        expectRefusal(wish, "camera-index: expected it without another camera position or direction, found both");
    }
}

TEST(FrameCamera, refusesACameraInsideOut) {
    CameraSettings wish;
    wish.position = glm::dvec3{1, 2, 3};
    wish.focalPoint = glm::dvec3{1, 2, 3};
    expectRefusal(wish, "camera-position: expected a place other than the focal point, found both at 1,2,3");
    wish = {};
    wish.direction = glm::dvec3{0.0};
    expectRefusal(wish, "camera-direction: expected a direction, found 0,0,0");
    wish.position = glm::dvec3{1, 2, 3};
    expectRefusal(wish, "camera-direction: expected a direction, found 0,0,0");
    wish = {};
    wish.viewUp = glm::dvec3{0.0};
    expectRefusal(wish, "camera-view-up: expected a direction, found 0,0,0");
    wish = {};
    wish.direction = glm::dvec3{0, 0, -2};
    wish.viewUp = glm::dvec3{0, 0, 3};
    expectRefusal(wish, "camera-view-up: expected a direction across the view direction 0,0,-1, found one along it");
}

TEST(FrameCamera, refusesNumbersOutOfRange) {
    CameraSettings wish;
    wish.viewAngle = 0.0;
    expectRefusal(wish, "camera-view-angle: expected degrees over 0 and under 180, found '0'");
    wish.viewAngle = 180.0;
    expectRefusal(wish, "camera-view-angle: expected degrees over 0 and under 180, found '180'");
    wish = {};
    wish.zoomFactor = 0.0;
    expectRefusal(wish, "camera-zoom-factor: expected a number over 0, found '0'");
    wish.zoomFactor = -2.0;
    expectRefusal(wish, "camera-zoom-factor: expected a number over 0, found '-2'");
    wish = {};
    wish.orthographicHeight = -1.0;
    expectRefusal(wish, "camera-orthographic: expected a number from 0 to 1.7976931348623157e+308, found '-1'");
}

}  // namespace
}  // namespace inkedge
