#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>

namespace inkedge::curves {

/// The ends of a path that a pen draws; of a closed path both are its start.
struct PathEnds {
    glm::dvec2 start;
    glm::dvec2 end;
};

/// A path in an order.
struct OrderedPath {
    std::size_t index;  ///< into the paths that were given
    bool reversed;      ///< drawn from its end to its start
};

/// An order, with each path once, in which a pen travels little from path to path: the nearest end that is left, then
/// exchanges of two ways for two shorter ones (2-opt) among paths that are near each other in the order. No promise of
/// the shortest. The same paths give the same order. O(n log n) on drawings, and at most O(n^2).
/// @param from  where the pen stands
[[nodiscard]] std::vector<OrderedPath> orderForTravel(std::span<const PathEnds>, glm::dvec2 from);

/// Lines in such an order, turned round where they are drawn so; closed ones begin where that is nearest.
/// @param pen  where the pen stands; then, where it stands after the last line
[[nodiscard]] std::vector<Line> inTravelOrder(std::vector<Line>, glm::dvec2& pen);

}  // namespace inkedge::curves
