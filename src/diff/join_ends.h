#pragma once

#include <vector>

#include <inkedge/compare_lines.h>

namespace inkedge::diff {

/// Joins open lines whose ends are as near as gap and go on into each other with little turn: the straightest joints
/// first. Lines of other types, visibilities or objects are not joined. A line whose own ends meet so is closed.
/// @param gap  pixels
/// Pure; O(n) times the number of ends near each other.
[[nodiscard]] std::vector<ComparedLine> joinEnds(std::vector<ComparedLine>, double gap);

}  // namespace inkedge::diff
