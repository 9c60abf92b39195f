#pragma once

#include <string_view>

namespace inkedge::load {

/// Checks that the data of a PLY file are as many as its header and its lists say. O(n).
/// @throws Error  (Kind::Input) if they are not, or if the header is not one that assimp reads safely
void checkPly(std::string_view content);

}  // namespace inkedge::load
