#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace inkedge::load {

/// What a PLY file says about its surface, fit for a reader that trusts its input: the vertices' positions and normals
/// and the faces' indices, as many as the header and the lists say, in the encoding of the file, text with one element
/// a line. Indices may be out of range. O(n).
/// @throws Error  (Kind::Input) if the file is no PLY, is truncated, or its header or a number is malformed
[[nodiscard]] std::vector<std::uint8_t> safePly(std::string_view content);

}  // namespace inkedge::load
