#pragma once

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include <inkedge/camera.h>
#include <inkedge/scene.h>

namespace inkedge::camera {

/// A rectangle in the plane of a picture: pixels right of and above its middle.
struct PicturePart {
    glm::dvec2 low{std::numeric_limits<double>::infinity()};
    glm::dvec2 high{-std::numeric_limits<double>::infinity()};

    [[nodiscard]] bool empty() const noexcept { return low.x > high.x || low.y > high.y; }
    [[nodiscard]] glm::dvec2 size() const noexcept { return high - low; }
    [[nodiscard]] glm::dvec2 middle() const noexcept { return 0.5 * (low + high); }
    void add(glm::dvec2 point) noexcept {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    void add(const PicturePart& other) noexcept {
        low = glm::min(low, other.low);
        high = glm::max(high, other.high);
    }
};

/// What the scene covers of the picture's plane, within the picture and beyond it, before the near plane; empty:
/// nothing lies there. Instances without an extent do not count unless none has one.
[[nodiscard]] PicturePart drawnPart(const Scene&, const Camera&, Size);

}  // namespace inkedge::camera
