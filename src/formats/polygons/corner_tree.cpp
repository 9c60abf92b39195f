#include "formats/polygons/corner_tree.h"

#include <algorithm>
#include <utility>

#include <glm/common.hpp>

#include "mesh/twice_area.h"

namespace inkedge::polygons {

void CornerTree::build(std::span<const glm::dvec2> points, std::vector<std::uint32_t> chosen) {
    points_ = points;
    order_ = std::move(chosen);
    leaf_.assign(points.size(), none);
    slot_.resize(points.size());
    nodes_.clear();
    if (order_.empty()) return;
    Node root;
    root.end = static_cast<std::uint32_t>(order_.size());
    root.parent = none;
    nodes_.push_back(root);
    for (std::uint32_t node = 0; node < nodes_.size(); ++node) split(node);
}

// Splits a node, unless it is small or all its points are equal: then it is a leaf.
void CornerTree::split(std::uint32_t number) {
    Node node = nodes_[number];
    node.low = node.high = points_[order_[node.begin]];
    for (std::uint32_t i = node.begin; i < node.end; ++i) {
        node.low = glm::min(node.low, points_[order_[i]]);
        node.high = glm::max(node.high, points_[order_[i]]);
    }
    node.alive = node.end - node.begin;
    constexpr std::uint32_t leafSize = 4;
    if (node.alive > leafSize && node.low != node.high) {
        const glm::dvec2 size = node.high - node.low;
        const int axis = size.x >= size.y ? 0 : 1;
        const std::uint32_t middle = node.begin + node.alive / 2;
        std::nth_element(order_.begin() + node.begin, order_.begin() + middle, order_.begin() + node.end,
                         [&](std::uint32_t a, std::uint32_t b) { return points_[a][axis] < points_[b][axis]; });
        node.left = static_cast<std::uint32_t>(nodes_.size());
        Node half;
        half.parent = number;
        half.begin = node.begin;
        half.end = middle;
        nodes_.push_back(half);
        half.begin = middle;
        half.end = node.end;
        nodes_.push_back(half);
    } else {
        for (std::uint32_t i = node.begin; i < node.end; ++i) leaf_[order_[i]] = number, slot_[order_[i]] = i;
    }
    nodes_[number] = node;
}

void CornerTree::remove(std::uint32_t point) {
    if (leaf_[point] == none) return;
    const Node& leaf = nodes_[leaf_[point]];
    const std::uint32_t at = slot_[point];
    const std::uint32_t last = leaf.begin + leaf.alive - 1;
    std::swap(order_[at], order_[last]);
    slot_[order_[at]] = at;
    for (std::uint32_t n = leaf_[point]; n != none; n = nodes_[n].parent) --nodes_[n].alive;
    leaf_[point] = none;
}

std::uint32_t CornerTree::within(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, std::uint64_t& steps) const {
    const glm::dvec2 low = glm::min(a, glm::min(b, c));
    const glm::dvec2 high = glm::max(a, glm::max(b, c));
    std::vector<std::uint32_t> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
        const Node& node = nodes_[open.back()];
        open.pop_back();
        ++steps;
        if (node.alive == 0 || node.low.x > high.x || node.low.y > high.y || node.high.x < low.x || node.high.y < low.y)
            continue;
        if (node.left != 0) {
            open.push_back(node.left);
            open.push_back(node.left + 1);
            continue;
        }
        const bool onePoint = node.low == node.high;
        for (std::uint32_t i = node.begin; i < node.begin + (onePoint ? 1 : node.alive); ++i) {
            const glm::dvec2 p = points_[order_[i]];
            ++steps;
            if (p == a || p == b || p == c) continue;
            if (mesh::twiceArea(a, b, p) >= 0.0 && mesh::twiceArea(b, c, p) >= 0.0 && mesh::twiceArea(c, a, p) >= 0.0)
                return order_[i];
        }
    }
    return none;
}

}  // namespace inkedge::polygons
