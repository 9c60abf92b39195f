#include "scene/load_stl.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "scene/load_file.h"
#include "scene/load_message.h"
#include "scene/load_text.h"

namespace inkedge::load {
namespace {

constexpr std::size_t headerSize = 80;
constexpr std::size_t dataStart = headerSize + 4;  // with the number of triangles
constexpr std::uint64_t triangleSize = 50;

std::uint64_t binarySize(const Bytes& bytes) {
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < 4; ++i) triangles |= std::uint64_t{bytes[headerSize + i]} << (8 * i);
    return dataStart + triangles * triangleSize;
}

void makeTextSafe(Bytes& bytes) {
    for (std::uint8_t& byte : bytes) {
        if (byte >= 'A' && byte <= 'Z') byte = static_cast<std::uint8_t>(byte + ('a' - 'A'));
        if (byte >= 0x80) byte = '?';
    }
    bytes.erase(bytes.begin(), std::ranges::find(bytes, std::uint8_t{'s'}));  // of solid: only blanks stand before it
    const std::string_view content = textOf(bytes);
    const std::size_t end = content.rfind("endsolid");
    const std::size_t facet = content.rfind("endfacet");
    if (end == std::string_view::npos || (facet != std::string_view::npos && end < facet))
        refuse("expected endsolid at the end, found none: the file is truncated");
}

}  // namespace

void makeStlSafe(Bytes& bytes) {
    const std::string_view content = textOf(bytes);
    const bool exact = bytes.size() >= dataStart && binarySize(bytes) == bytes.size();
    const bool looksLikeText = !exact && content.find('\0') == std::string_view::npos;
    if (looksLikeText) {
        const std::string_view start = trimmed(content).substr(0, 5);
        if (start == "solid" || start == "SOLID") return makeTextSafe(bytes);
        refuse(fmt::format("expected STL, found {}", kindOf(content)));
    }
    if (bytes.size() < dataStart)
        refuse(fmt::format("expected an STL file of at least {} bytes, found {}", dataStart, bytes.size()));
    if (const std::uint64_t size = binarySize(bytes); size > bytes.size())
        refuse(fmt::format("expected {} bytes for the {} triangles that the header says, found {}: the file is "
                           "truncated or no STL",
                           size, (size - dataStart) / triangleSize, bytes.size()));
    bytes.resize(binarySize(bytes));
    std::fill_n(bytes.begin(), headerSize, std::uint8_t{0});
}

}  // namespace inkedge::load
