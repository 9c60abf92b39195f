#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/camera.h>
#include <inkedge/error.h>
#include <inkedge/setting_table.h>

#include "scene/extent.h"

namespace inkedge {
namespace {

constexpr double threeQuarterAzimuth = 30.0;
constexpr double threeQuarterElevation = 20.0;
constexpr double frameShare = 0.92;  // of the picture's width or height that a framed model fills
// Of the bounds' radius: keeps the camera from a spike of the model that is sharper than the view angle.
constexpr double clearance = 0.1;
constexpr double nearestShare = 1e-4;   // of far: the near plane of a camera inside or beside the model
constexpr double boundsMargin = 1.001;  // keeps the outermost vertex off the near and far planes

[[noreturn]] void refuse(const std::string& message) { throw Error{Error::Kind::Usage, message}; }

// Right-handed: right, up, and forward, into the scene.
struct Axes {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;
};

// @param azimuth  degrees: where a view straight down or up would come from if it were tilted
Axes axesAlong(glm::dvec3 forward, const std::optional<glm::dvec3>& givenUp, double azimuth) {
    const glm::dvec3 unitForward = glm::normalize(forward);
    glm::dvec3 up = givenUp.value_or(glm::dvec3{0, 1, 0});
    if (glm::length(up) == 0.0) refuse("camera-view-up: expected a direction, found 0,0,0");
    up = glm::normalize(up);
    if (glm::length(glm::cross(unitForward, up)) < 1e-9) {
        if (givenUp) {
            refuse(fmt::format(
                "camera-view-up: expected a direction across the view direction {},{},{}, found one along it",
                unitForward.x, unitForward.y, unitForward.z));
        }
        const double a = glm::radians(azimuth);
        up = (unitForward.y > 0.0 ? 1.0 : -1.0) * glm::dvec3{std::sin(a), 0.0, std::cos(a)};
    }
    const glm::dvec3 right = glm::normalize(glm::cross(unitForward, up));
    return {right, glm::cross(right, unitForward), unitForward};
}

glm::dmat4 viewFrom(glm::dvec3 position, const Axes& axes) {
    glm::dmat4 view{1.0};
    for (int i = 0; i < 3; ++i) {
        view[i][0] = axes.right[i];
        view[i][1] = axes.up[i];
        view[i][2] = -axes.forward[i];
    }
    view[3] = {-glm::dot(axes.right, position), -glm::dot(axes.up, position), glm::dot(axes.forward, position), 1.0};
    return view;
}

// The direction that azimuth and elevation look along, towards the model.
glm::dvec3 directionFrom(double azimuth, double elevation) {
    const double a = glm::radians(azimuth);
    const double e = glm::radians(elevation);
    return -glm::dvec3{std::cos(e) * std::sin(a), std::sin(e), std::cos(e) * std::cos(a)};
}

glm::dvec3 viewDirection(const CameraSettings& settings, glm::dvec3 focalPoint) {
    if (settings.direction) {
        if (glm::length(*settings.direction) == 0.0) refuse("camera-direction: expected a direction, found 0,0,0");
        return *settings.direction;
    }
    if (settings.position) {
        const glm::dvec3 direction = focalPoint - *settings.position;
        if (glm::length(direction) == 0.0) {
            refuse(fmt::format("camera-position: expected a place other than the focal point, found both at {},{},{}",
                               focalPoint.x, focalPoint.y, focalPoint.z));
        }
        return direction;
    }
    return directionFrom(settings.azimuthAngle.value_or(threeQuarterAzimuth),
                         settings.elevationAngle.value_or(threeQuarterElevation));
}

void checkForContradictions(const CameraSettings& settings) {
    const bool angles = settings.azimuthAngle || settings.elevationAngle;
    const auto exclude = [](bool both, const char* one, const char* other) {
        if (both) refuse(fmt::format("{}: expected it without {}, found both", one, other));
    };
    exclude(angles && settings.direction, "camera-direction", "an azimuth or elevation angle");
    exclude(angles && settings.position, "camera-position", "an azimuth or elevation angle");
    exclude(settings.position && settings.direction && settings.focalPoint, "camera-direction",
            "both camera-position and camera-focal-point");
    exclude(
        settings.index && (settings.position || settings.focalPoint || settings.direction || settings.viewUp || angles),
        "camera-index", "another camera position or direction");
}

// How far the scene reaches from the centre line along an axis, for a frustum side of slope s (0: orthographic). Depth
// is measured from the world's origin along forward. A point p is inside the side if axis . p - s * depth <= reach.
double reach(const Scene& scene, glm::dvec3 axis, double slope, glm::dvec3 forward) {
    return scene::support(scene, axis - slope * forward);
}

// Moves a camera that looks along the axes to where the model just fills the frame.
void frameAll(Camera& camera, const Scene& scene, const Axes& axes, Size size) {
    const double aspect = static_cast<double>(size.width) / size.height;
    const double slopeY = camera.orthographic() ? 0.0 : std::tan(glm::radians(camera.viewAngle) / 2.0) * frameShare;
    const double slopeX = slopeY * aspect;
    const double right = reach(scene, axes.right, slopeX, axes.forward);
    const double left = reach(scene, -axes.right, slopeX, axes.forward);
    const double top = reach(scene, axes.up, slopeY, axes.forward);
    const double bottom = reach(scene, -axes.up, slopeY, axes.forward);
    const glm::dvec3 across = 0.5 * (right - left) * axes.right + 0.5 * (top - bottom) * axes.up;
    const Sphere& bounds = scene.bounds();
    if (camera.orthographic()) {
        const double distance = glm::dot(bounds.centre, axes.forward) - 2.0 * bounds.radius;
        camera.view = viewFrom(across + distance * axes.forward, axes);
        const double height = std::max(top + bottom, (left + right) / aspect) / frameShare;
        camera.orthographicHeight = height > 0.0 ? height : 1.0;
    } else {
        // Both sides pass through the camera: the sum of their reaches is -2 slope * depth of the camera.
        const double fitting = std::max((right + left) / (2.0 * slopeX), (top + bottom) / (2.0 * slopeY));
        const double clear = scene::support(scene, -axes.forward) + clearance * bounds.radius;
        const double behind = std::max(fitting, clear);
        camera.view = viewFrom(across - behind * axes.forward, axes);
    }
}

void fitNearAndFar(Camera& camera, const Sphere& bounds) {
    const double centreDepth = -(camera.view * glm::dvec4{bounds.centre, 1.0}).z;
    const double radius = bounds.radius > 0.0 ? bounds.radius * boundsMargin : 1.0;
    camera.far = std::max(centreDepth + radius, radius * nearestShare);
    camera.near = std::max(centreDepth - radius, camera.orthographic() ? 0.0 : camera.far * nearestShare);
    if (camera.near >= camera.far) camera.near = 0.5 * camera.far;  // all behind the camera: nothing is drawn
}

void takeFileCamera(Camera& camera, const Scene& scene, int index) {
    if (static_cast<std::size_t>(index) >= scene.cameras().size()) {
        refuse(fmt::format("camera-index: expected a camera of the file, 0 to below {}, found {}",
                           scene.cameras().size(), index));
    }
    const SceneCamera& source = scene.cameras()[static_cast<std::size_t>(index)];
    camera.view = glm::inverse(source.transform);
    camera.viewAngle = source.viewAngle;
    camera.orthographicHeight = source.orthographicHeight;
}

}  // namespace

Camera frameCamera(const Scene& scene, const CameraSettings& settings, Size size) {
    validate(settings);
    checkForContradictions(settings);
    Camera camera;
    camera.viewAngle = settings.viewAngle;
    // A height of 0 asks for a framed one. frameAll() and the zoom below need to know that the camera is orthographic
    // before its height is known.
    const bool frameHeight = settings.orthographicHeight && *settings.orthographicHeight == 0.0;
    camera.orthographicHeight = frameHeight ? 1.0 : settings.orthographicHeight.value_or(0.0);

    if (settings.index) {
        takeFileCamera(camera, scene, *settings.index);
    } else {
        const glm::dvec3 focalPoint = settings.focalPoint.value_or(scene.bounds().centre);
        const Axes axes =
            axesAlong(viewDirection(settings, focalPoint), settings.viewUp, settings.azimuthAngle.value_or(0.0));
        Camera framed = camera;
        if (!settings.position || frameHeight) frameAll(framed, scene, axes, size);
        if (frameHeight) camera.orthographicHeight = framed.orthographicHeight;
        if (settings.position) {
            camera.view = viewFrom(*settings.position, axes);
        } else if (settings.focalPoint) {
            const double distance = glm::length(glm::dvec3{glm::inverse(framed.view)[3]} - scene.bounds().centre);
            camera.view = viewFrom(focalPoint - distance * axes.forward, axes);
        } else {
            camera.view = framed.view;
        }
    }
    if (camera.orthographic()) {
        camera.orthographicHeight /= settings.zoomFactor;
    } else {
        const double slope = std::tan(glm::radians(camera.viewAngle) / 2.0) / settings.zoomFactor;
        camera.viewAngle = glm::degrees(2.0 * std::atan(slope));
    }
    fitNearAndFar(camera, scene.bounds());
    return camera;
}

}  // namespace inkedge
