#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

namespace inkedge::polygons {

/// A tree over points in the plane that finds a point in a triangle. Points can be removed.
class CornerTree {
public:
    /// @param points  all points of the plane; must outlive the tree
    /// @param chosen  into points: those that the tree holds
    void build(std::span<const glm::dvec2> points, std::vector<std::uint32_t> chosen);

    void remove(std::uint32_t point);

    /// Any point within the triangle a, b, c (anticlockwise) or on its border, except points at its corners.
    /// @param steps  counts the nodes and points that were looked at
    /// @return       into points, or none
    [[nodiscard]] std::uint32_t within(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, std::uint64_t& steps) const;
    static constexpr std::uint32_t none = ~0U;

private:
    struct Node {
        glm::dvec2 low{0.0};
        glm::dvec2 high{0.0};
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        std::uint32_t left = 0;  // the right one follows it; 0: a leaf
        std::uint32_t parent = 0;
        std::uint32_t alive = 0;
    };
    void split(std::uint32_t node);

    std::span<const glm::dvec2> points_;
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> leaf_;  // one per point of the plane; none: not held
    std::vector<std::uint32_t> slot_;  // one per point of the plane: its index in order_
    std::vector<Node> nodes_;
};

}  // namespace inkedge::polygons
