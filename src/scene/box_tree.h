#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/scene.h>

namespace inkedge::scene {

/// Finds the boxes that overlap another: a tree of boxes, halved at the median of their longest side.
class BoxTree {
public:
    /// O(n log n)
    explicit BoxTree(std::span<const Box> boxes);

    /// Calls visit(i, box) for each box i that shares a point with this one.
    /// @param stepsLeft  boxes that may still be looked at; the search ends when none are left
    template <class Visit>
    void forEachOverlap(const Box& box, std::uint64_t& stepsLeft, Visit&& visit) const {
        if (!boxes_.empty()) search(0, 0, boxes_.size(), box, stepsLeft, visit);
    }

private:
    static constexpr std::size_t leafSize = 8;

    [[nodiscard]] static bool overlap(const Box& a, const Box& b) noexcept {
        return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y &&
               a.min.z <= b.max.z && b.min.z <= a.max.z;
    }

    void build(std::span<const Box> boxes, std::size_t node, std::size_t begin, std::size_t end);

    template <class Visit>
    void search(std::size_t node, std::size_t begin, std::size_t end, const Box& box, std::uint64_t& stepsLeft,
                Visit&& visit) const {
        if (stepsLeft == 0 || !overlap(bounds_[node], box)) return;
        --stepsLeft;
        if (end - begin > leafSize) {
            const std::size_t middle = (begin + end) / 2;
            search(2 * node + 1, begin, middle, box, stepsLeft, visit);
            search(2 * node + 2, middle, end, box, stepsLeft, visit);
            return;
        }
        for (std::size_t i = begin; i < end && stepsLeft > 0; ++i) {
            --stepsLeft;
            if (overlap(boxes_[i], box)) visit(order_[i], boxes_[i]);
        }
    }

    std::vector<Box> boxes_;            // those of a node are consecutive
    std::vector<std::uint32_t> order_;  // the index of each box in the constructor's list
    std::vector<Box> bounds_;           // one per node; the children of node n are 2 n + 1 and 2 n + 2
};

}  // namespace inkedge::scene
