#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace inkedge::load {

/// The formats that loadAssimp() reads.
enum class PolygonFormat { Obj, Stl, Ply };

[[nodiscard]] std::string_view name(PolygonFormat) noexcept;

/// Makes a file's bytes safe for a reader that trusts what they say, as far as can be told without reading them whole:
/// counts fit the size, a binary STL is cut to its triangles and loses its header's text, a text STL is in lower-case
/// ASCII, and text holds no zero byte.
/// @throws Error  (Kind::Input) if the bytes are not of the format, or are truncated
void checkContent(PolygonFormat, std::vector<std::uint8_t>& bytes);

}  // namespace inkedge::load
