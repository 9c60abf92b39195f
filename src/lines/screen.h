#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/camera.h>

namespace inkedge::lines {

/// A point as the camera sees it.
struct ScreenPoint {
    glm::dvec2 pixel;  ///< as LinePoint::pixel
    /// 1 / depth, or -depth in an orthographic view: larger is nearer; linear along straight lines of the picture.
    double inverseDepth;
};

/// Projects points to a picture and back. World positions are less an origin: the centre of the scene's bounds.
class Screen {
public:
    Screen(const Camera&, glm::dvec3 origin, Size);

    [[nodiscard]] bool orthographic() const noexcept { return orthographic_; }
    [[nodiscard]] Size size() const noexcept { return size_; }
    [[nodiscard]] glm::dvec3 eye() const noexcept { return eye_; }              ///< perspective
    [[nodiscard]] glm::dvec3 direction() const noexcept { return direction_; }  ///< unit, into the scene
    [[nodiscard]] double near() const noexcept { return near_; }                ///< depth of the near plane

    /// Depth of a point along the view direction.
    [[nodiscard]] double depth(glm::dvec3 world) const noexcept { return glm::dot(direction_, world - eye_); }
    /// @param world  behind the near plane
    [[nodiscard]] ScreenPoint project(glm::dvec3 world) const noexcept;
    /// The inverse of project().
    [[nodiscard]] glm::dvec3 worldAt(const ScreenPoint&) const noexcept;
    /// The footprint of a pixel at a point: its height in world units.
    [[nodiscard]] double footprint(glm::dvec3 world) const noexcept {
        return orthographic_ ? 1.0 / focalLength_ : depth(world) / focalLength_;
    }
    /// How far p lies before q, in pixel footprints at p.
    [[nodiscard]] double footprintsBefore(double inverseDepthP, double inverseDepthQ) const noexcept {
        return orthographic_ ? (inverseDepthP - inverseDepthQ) * focalLength_
                             : (inverseDepthP - inverseDepthQ) / inverseDepthQ * focalLength_;
    }
    /// A vector in the picture (x to the right, y down) as a vector in world space, at the depth of a point.
    [[nodiscard]] glm::dvec3 across(glm::dvec2 pixels, glm::dvec3 world) const noexcept {
        return (right_ * (pixels.x * pixelAspect_) - up_ * pixels.y) * footprint(world);
    }
    /// From the eye to a point; in orthographic views, from the camera's plane.
    [[nodiscard]] glm::dvec3 ray(glm::dvec3 world) const noexcept {
        return orthographic_ ? direction_ * depth(world) : world - eye_;
    }
    /// The share of the way from p to q in space at the share u of the way from p to q in the picture.
    [[nodiscard]] double unproject(double u, double inverseDepthP, double inverseDepthQ) const noexcept {
        return orthographic_ ? u : u * inverseDepthQ / ((1.0 - u) * inverseDepthP + u * inverseDepthQ);
    }

private:
    Size size_;
    glm::dvec2 centre_;
    bool orthographic_;
    double focalLength_;
    double pixelAspect_;
    double near_;
    glm::dvec3 right_;
    glm::dvec3 up_;
    glm::dvec3 direction_;
    glm::dvec3 eye_;
};

}  // namespace inkedge::lines
