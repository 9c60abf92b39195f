#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "lines/find/four.h"

namespace inkedge::lines {

/// Four boxes side by side, so that a processor compares four at once. A box that is none lies at infinity.
struct FourBoxes {
    static constexpr float none = std::numeric_limits<float>::infinity();
    Four low[3]{four(none), four(none), four(none)};  ///< one per axis
    Four high[3]{four(none), four(none), four(none)};

    void set(std::size_t k, glm::vec3 min, glm::vec3 max) noexcept {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis][k] = min[axis];
            high[axis][k] = max[axis];
        }
    }
    [[nodiscard]] glm::vec3 min(std::size_t k) const noexcept { return {low[0][k], low[1][k], low[2][k]}; }
    [[nodiscard]] glm::vec3 max(std::size_t k) const noexcept { return {high[0][k], high[1][k], high[2][k]}; }
};

/// Boxes in a tree, four to a node, in the order in which they are given: neighbours in that order should be near each
/// other in space. Node i of a level holds what lies below nodes 4 i to 4 i + 3 of the level under it; the boxes
/// themselves are level 0.
class BoxLevels {
public:
    BoxLevels() = default;
    /// @param bottom  ceil(count / 4)
    BoxLevels(std::vector<FourBoxes> bottom, std::size_t count) {
        levels_.push_back(std::move(bottom));
        counts_.push_back(static_cast<std::uint32_t>(count));
        while (levels_.back().size() > 1) addLevel();
    }

    [[nodiscard]] bool empty() const noexcept { return counts_.empty() || counts_.front() == 0; }
    /// The level of the root, whose index is 0; 1 or more.
    [[nodiscard]] std::uint32_t top() const noexcept { return static_cast<std::uint32_t>(levels_.size()); }
    [[nodiscard]] std::uint32_t count(std::uint32_t level) const noexcept { return counts_[level]; }
    /// The boxes of nodes 4 i to 4 i + 3 of a level: the children of node i above.
    [[nodiscard]] const FourBoxes& boxes(std::uint32_t level, std::uint32_t i) const noexcept {
        return levels_[level][i];
    }

private:
    void addLevel() {
        const std::vector<FourBoxes>& below = levels_.back();
        std::vector<FourBoxes> above((below.size() + 3) / 4);
        for (std::size_t i = 0; i < below.size(); ++i) {
            const auto end = std::min<std::size_t>(4, counts_.back() - 4 * i);
            glm::vec3 min = below[i].min(0);
            glm::vec3 max = below[i].max(0);
            for (std::size_t k = 1; k < end; ++k) {
                for (int axis = 0; axis < 3; ++axis) {
                    min[axis] = std::min(min[axis], below[i].low[axis][k]);
                    max[axis] = std::max(max[axis], below[i].high[axis][k]);
                }
            }
            above[i / 4].set(i % 4, min, max);
        }
        counts_.push_back(static_cast<std::uint32_t>(below.size()));
        levels_.push_back(std::move(above));
    }

    std::vector<std::vector<FourBoxes>> levels_;
    std::vector<std::uint32_t> counts_;  // of nodes of each level
};

}  // namespace inkedge::lines
