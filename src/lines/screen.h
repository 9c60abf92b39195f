#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/camera.h>

namespace inkedge::lines {

/// A point as the camera sees it.
struct ScreenPoint {
    glm::dvec2 place;  ///< pixels, (0, 0) the picture's top left corner
    double nearness;   ///< the larger, the nearer; linear along straight lines of the picture: 1 / depth, or -depth in
                       ///< orthographic views
};

/// A camera over a picture. World space is less an origin: the centre of the scene's bounds.
class Screen {
public:
    Screen(const Camera&, glm::dvec3 origin, Size);

    [[nodiscard]] bool orthographic() const noexcept { return orthographic_; }
    [[nodiscard]] Size size() const noexcept { return size_; }
    [[nodiscard]] glm::dvec3 eye() const noexcept { return eye_; }              ///< perspective
    [[nodiscard]] glm::dvec3 direction() const noexcept { return direction_; }  ///< unit, into the scene
    [[nodiscard]] double near() const noexcept { return near_; }                ///< depth of the near plane

    /// Along the view direction.
    [[nodiscard]] double depth(glm::dvec3 world) const noexcept { return glm::dot(direction_, world - eye_); }
    /// @param world  before the near plane
    [[nodiscard]] ScreenPoint project(glm::dvec3 world) const noexcept;
    /// The point that a place of the picture shows.
    [[nodiscard]] glm::dvec3 worldAt(const ScreenPoint&) const noexcept;
    /// World units across a pixel at a point.
    [[nodiscard]] double footprint(glm::dvec3 world) const noexcept {
        return orthographic_ ? 1.0 / focalLength_ : depth(world) / focalLength_;
    }
    /// How far lies p before q, in pixels across at p.
    [[nodiscard]] double footprintsBefore(double nearnessP, double nearnessQ) const noexcept {
        return orthographic_ ? (nearnessP - nearnessQ) * focalLength_
                             : (nearnessP - nearnessQ) / nearnessQ * focalLength_;
    }
    /// World space across the picture, a pixel to the right and one down, at a point.
    [[nodiscard]] glm::dvec3 across(glm::dvec2 pixels, glm::dvec3 world) const noexcept {
        return (right_ * pixels.x - up_ * pixels.y) * footprint(world);
    }
    /// From the eye to a point; in orthographic views, from the camera's plane.
    [[nodiscard]] glm::dvec3 ray(glm::dvec3 world) const noexcept {
        return orthographic_ ? direction_ * depth(world) : world - eye_;
    }
    /// Where on the straight piece from p to q the picture shows what lies at u, 0 to 1, between their places.
    [[nodiscard]] double unproject(double u, double nearnessP, double nearnessQ) const noexcept {
        return orthographic_ ? u : u * nearnessQ / ((1.0 - u) * nearnessP + u * nearnessQ);
    }

private:
    Size size_;
    bool orthographic_;
    double focalLength_;
    double near_;
    glm::dvec3 right_;
    glm::dvec3 up_;
    glm::dvec3 direction_;
    glm::dvec3 eye_;
};

}  // namespace inkedge::lines
