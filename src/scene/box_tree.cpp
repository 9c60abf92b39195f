#include "scene/box_tree.h"

#include <algorithm>
#include <bit>
#include <numeric>

#include <glm/common.hpp>

namespace inkedge::scene {

BoxTree::BoxTree(std::span<const Box> boxes) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    bounds_.resize(2 * std::bit_ceil(boxes.size() / leafSize + 1));
    if (!boxes.empty()) build(boxes, 0, 0, boxes.size());
    boxes_.reserve(boxes.size());
    for (const std::uint32_t i : order_) boxes_.push_back(boxes[i]);
}

void BoxTree::build(std::span<const Box> boxes, std::size_t node, std::size_t begin, std::size_t end) {
    Box& bounds = bounds_[node];
    bounds = boxes[order_[begin]];
    for (std::size_t i = begin + 1; i < end; ++i) {
        bounds.min = glm::min(bounds.min, boxes[order_[i]].min);
        bounds.max = glm::max(bounds.max, boxes[order_[i]].max);
    }
    if (end - begin <= leafSize) return;
    const glm::dvec3 size = bounds.max - bounds.min;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = static_cast<std::ptrdiff_t>((begin + end) / 2);
    std::nth_element(order_.begin() + static_cast<std::ptrdiff_t>(begin), order_.begin() + middle,
                     order_.begin() + static_cast<std::ptrdiff_t>(end), [&](std::uint32_t a, std::uint32_t b) {
                         return boxes[a].min[axis] + boxes[a].max[axis] < boxes[b].min[axis] + boxes[b].max[axis];
                     });
    build(boxes, 2 * node + 1, begin, static_cast<std::size_t>(middle));
    build(boxes, 2 * node + 2, static_cast<std::size_t>(middle), end);
}

}  // namespace inkedge::scene
