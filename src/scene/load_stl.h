#pragma once

#include <cstdint>
#include <vector>

namespace inkedge::load {

/// Makes an STL file's bytes safe for a reader that trusts what they say: a binary one is cut to its triangles and loses
/// its header's text, a text one is in lower-case ASCII. O(n).
/// @throws Error  (Kind::Input) if they are no STL, or are truncated
void makeStlSafe(std::vector<std::uint8_t>& bytes);

}  // namespace inkedge::load
