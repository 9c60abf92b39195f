#pragma once

#include <glm/vec2.hpp>

namespace inkedge::sheet {

/// A rectangle on the page, millimetres from its top left corner, y down.
struct Rect {
    glm::dvec2 low{0.0};
    glm::dvec2 high{0.0};

    [[nodiscard]] glm::dvec2 size() const noexcept { return high - low; }
    [[nodiscard]] glm::dvec2 middle() const noexcept { return 0.5 * (low + high); }
    /// The same, larger by so much on each side.
    [[nodiscard]] Rect grown(double by) const noexcept { return {low - by, high + by}; }
    [[nodiscard]] bool overlaps(const Rect& other) const noexcept {
        return low.x < other.high.x && other.low.x < high.x && low.y < other.high.y && other.low.y < high.y;
    }
};

}  // namespace inkedge::sheet
