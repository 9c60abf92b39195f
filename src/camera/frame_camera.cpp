#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/camera.h>
#include <inkedge/setting_table.h>

#include "base/message.h"
#include "camera/framing.h"
#include "scene/extent.h"
#include "settings/text.h"

namespace inkedge {
namespace {

constexpr double defaultViewAngle = 35.0;  // degrees
constexpr double threeQuarterAzimuth = 30.0;
constexpr double threeQuarterElevation = 20.0;
// Of the bounds' radius: keeps the camera from a spike of the model that is sharper than the view angle.
constexpr double clearance = 0.1;
constexpr double nearestShare = 1e-4;   // of far: the near plane of a camera inside or beside the model
constexpr double boundsMargin = 1.001;  // keeps the outermost vertex off the near and far planes

// Right-handed: right, up, and forward, into the scene.
struct Axes {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 forward;
};

// The axes of the model itself: see Scene::up() and Scene::front().
struct ModelAxes {
    explicit ModelAxes(const Scene& scene) : up{scene.up()}, front{scene.front()}, right{glm::cross(up, front)} {}

    // The direction that azimuth and elevation look along, towards the model.
    [[nodiscard]] glm::dvec3 directionFrom(double azimuth, double elevation) const {
        const double a = glm::radians(azimuth);
        const double e = glm::radians(elevation);
        return -(std::cos(e) * std::sin(a) * right + std::sin(e) * up + std::cos(e) * std::cos(a) * front);
    }

    [[nodiscard]] glm::dvec3 directionOf(NamedView view) const {
        switch (view) {
            case NamedView::Front:
                return -front;
            case NamedView::Back:
                return front;
            case NamedView::Left:
                return right;
            case NamedView::Right:
                return -right;
            case NamedView::Top:
                return -up;
            case NamedView::Bottom:
                return up;
            case NamedView::Iso:
                return -(right + up + front);
            case NamedView::Dimetric:  // scales of right and up are sqrt(8) / 3, that of front is half as much
                break;
        }
        return -(right + up + std::sqrt(7.0) * front);
    }

    glm::dvec3 up;
    glm::dvec3 front;
    glm::dvec3 right;
};

bool isAlong(glm::dvec3 unitForward, glm::dvec3 unitUp) { return glm::length(glm::cross(unitForward, unitUp)) < 1e-9; }

// Which way is up in the picture; it need not be across the view direction.
glm::dvec3 upOf(const CameraSettings& settings, const ModelAxes& model, glm::dvec3 unitForward) {
    if (settings.viewUp) {
        if (glm::length(*settings.viewUp) == 0.0)
            base::refuseUse("--camera-view-up: expected a direction, found 0,0,0");
        const glm::dvec3 up = glm::normalize(*settings.viewUp);
        if (!isAlong(unitForward, up)) return up;
        if (settings.direction || settings.position) {
            base::refuseUse(
                fmt::format("--camera-view-up: expected a direction across the view direction {}, found one along "
                            "it",
                            settings::textOf(unitForward)));
        }
    }
    if (!isAlong(unitForward, model.up)) return model.up;
    // A view straight down or up is seen as if it were tilted a little: down from the front, it has the front below.
    const double a = glm::radians(settings.azimuthAngle.value_or(0.0));
    return (glm::dot(unitForward, model.up) > 0.0 ? 1.0 : -1.0) *
           (std::sin(a) * model.right + std::cos(a) * model.front);
}

Axes axesAlong(glm::dvec3 forward, const CameraSettings& settings, const ModelAxes& model) {
    const glm::dvec3 unitForward = glm::normalize(forward);
    const glm::dvec3 up = upOf(settings, model, unitForward);
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

glm::dvec3 viewDirection(const CameraSettings& settings, const ModelAxes& model, glm::dvec3 focalPoint) {
    if (settings.direction) {
        if (glm::length(*settings.direction) == 0.0)
            base::refuseUse("--camera-direction: expected a direction, found 0,0,0");
        return *settings.direction;
    }
    if (settings.position) {
        const glm::dvec3 direction = focalPoint - *settings.position;
        if (glm::length(direction) == 0.0) {
            base::refuseUse(
                fmt::format("--camera-position: expected a place other than the focal point, found both at {}",
                            settings::textOf(focalPoint)));
        }
        return direction;
    }
    if (settings.view) return model.directionOf(*settings.view);
    return model.directionFrom(settings.azimuthAngle.value_or(threeQuarterAzimuth),
                               settings.elevationAngle.value_or(threeQuarterElevation));
}

void checkForContradictions(const CameraSettings& settings) {
    const bool angles = settings.azimuthAngle || settings.elevationAngle;
    const auto exclude = [](bool both, const char* one, const char* other) {
        if (both) base::refuseUse(fmt::format("{}: expected it without {}, found both", one, other));
    };
    exclude(angles && settings.direction, "--camera-direction", "an azimuth or elevation angle");
    exclude(angles && settings.position, "--camera-position", "an azimuth or elevation angle");
    exclude(settings.position && settings.direction && settings.focalPoint, "--camera-direction",
            "both --camera-position and --camera-focal-point");
    const bool view = settings.view.has_value();
    exclude(settings.index &&
                (settings.position || settings.focalPoint || settings.direction || settings.viewUp || angles || view),
            "--camera-index", "another camera position or direction");
    exclude(view && (settings.position || settings.direction || angles), "--view",
            "another camera position or direction");
}

// How far the scene reaches from the centre line along an axis, for a frustum side of slope s (0: orthographic). Depth
// is measured from the world's origin along forward. A point p is inside the side if axis . p - s * depth <= reach.
double reach(const Scene& scene, glm::dvec3 axis, double slope, glm::dvec3 forward) {
    return scene::support(scene, axis - slope * forward);
}

// Moves a camera that looks along the axes to where the model just fills the frame.
void frameAll(Camera& camera, const Scene& scene, const Axes& axes, Size size) {
    const double aspect = static_cast<double>(size.width) / size.height;
    const double slopeY =
        camera.orthographic() ? 0.0 : std::tan(glm::radians(camera.viewAngle) / 2.0) * camera::frameShare;
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
        const double height = std::max(top + bottom, (left + right) / aspect) / camera::frameShare;
        camera.orthographicHeight = height > 0.0 ? height : 1.0;
    } else {
        // Both sides pass through the camera: the sum of their reaches is -2 slope * depth of the camera.
        const double fitting = std::max((right + left) / (2.0 * slopeX), (top + bottom) / (2.0 * slopeY));
        const double clear = scene::support(scene, -axes.forward) + clearance * bounds.radius;
        const double behind = std::max(fitting, clear);
        camera.view = viewFrom(across - behind * axes.forward, axes);
    }
}

void takeFileCamera(Camera& camera, const Scene& scene, int index) {
    if (static_cast<std::size_t>(index) >= scene.cameras().size()) {
        if (scene.cameras().empty())
            base::refuseUse(
                fmt::format("--camera-index: expected a camera of the file, found {} for one that has none", index));
        base::refuseUse(fmt::format("--camera-index: expected a camera of the file, 0 to below {}, found {}",
                                    scene.cameras().size(), index));
    }
    const SceneCamera& source = scene.cameras()[static_cast<std::size_t>(index)];
    camera.view = glm::inverse(source.transform);
    camera.viewAngle = source.viewAngle;
    camera.orthographicHeight = source.orthographicHeight;
}

}  // namespace

namespace camera {

void fitNearAndFar(Camera& camera, const Sphere& bounds) {
    const double centreDepth = -(camera.view * glm::dvec4{bounds.centre, 1.0}).z;
    const double radius = bounds.radius > 0.0 ? bounds.radius * boundsMargin : 1.0;
    camera.far = std::max(centreDepth + radius, radius * nearestShare);
    camera.near = std::max(centreDepth - radius, camera.orthographic() ? 0.0 : camera.far * nearestShare);
    if (camera.near >= camera.far) camera.near = 0.5 * camera.far;  // all behind the camera: nothing is drawn
}

}  // namespace camera

Camera withPlanes(Camera camera, const Scene& scene) noexcept {
    if (camera.far == 0.0) camera::fitNearAndFar(camera, scene.bounds());
    return camera;
}

Camera frameCamera(const Scene& scene, const CameraSettings& settings, Size size) {
    validate(settings);
    checkForContradictions(settings);
    Camera camera;
    camera.viewAngle = settings.viewAngle.value_or(defaultViewAngle);
    // A height of 0 asks for a framed one, and so does a named view. frameAll() and the zoom below need to know that
    // the camera is orthographic before its height is known.
    std::optional<double> height = settings.orthographicHeight;
    if (settings.view && !settings.viewAngle && !height) height = 0.0;
    const bool frameHeight = height && *height == 0.0;
    camera.orthographicHeight = frameHeight ? 1.0 : height.value_or(0.0);

    if (settings.index) {
        takeFileCamera(camera, scene, *settings.index);
    } else {
        const glm::dvec3 focalPoint = settings.focalPoint.value_or(scene.bounds().centre);
        const ModelAxes model{scene};
        const Axes axes = axesAlong(viewDirection(settings, model, focalPoint), settings, model);
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
    camera::fitNearAndFar(camera, scene.bounds());
    return camera;
}

}  // namespace inkedge
