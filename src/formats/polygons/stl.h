#pragma once

#include <cstdint>
#include <vector>

namespace inkedge::load {

/// An STL file, binary or text, made fit for a reader that trusts its input: a binary one without text in its header,
/// and with the size that its number of triangles gives. Facet normals are left out of a text file's. O(n).
/// @throws Error  (Kind::Input) if the file is no STL or is truncated, or if text is malformed; the message then names
///                the facet
[[nodiscard]] std::vector<std::uint8_t> safeStl(std::vector<std::uint8_t> bytes);

}  // namespace inkedge::load
