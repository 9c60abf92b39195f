#include "scene/load_format.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "scene/load_file.h"
#include "scene/load_message.h"

namespace inkedge::load {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

std::string_view trimmed(std::string_view text) {
    const std::size_t start = text.find_first_not_of(blanks);
    return start == std::string_view::npos ? std::string_view{} : text.substr(start);
}

// The first word, taken off the text.
std::string_view takeWord(std::string_view& text) {
    text = trimmed(text);
    const std::string_view word = text.substr(0, text.find_first_of(blanks));
    text.remove_prefix(word.size());
    return word;
}

void checkText(std::string_view content, std::string_view format) {
    if (const std::size_t zero = content.find('\0'); zero != std::string_view::npos)
        refuse(fmt::format("expected {}, found a zero byte at byte {}", format, zero));
}

// ---- STL

constexpr std::size_t stlHeader = 80;
constexpr std::size_t stlStart = stlHeader + 4;  // with the number of triangles
constexpr std::uint64_t stlTriangle = 50;

std::uint64_t binaryStlSize(const Bytes& bytes) {
    std::uint64_t triangles = 0;
    for (std::size_t i = 0; i < 4; ++i) triangles |= std::uint64_t{bytes[stlHeader + i]} << (8 * i);
    return stlStart + triangles * stlTriangle;
}

void checkTextStl(Bytes& bytes) {
    for (std::uint8_t& byte : bytes) {
        if (byte >= 'A' && byte <= 'Z') byte = static_cast<std::uint8_t>(byte + ('a' - 'A'));
        if (byte >= 0x80) byte = '?';
    }
    const std::string_view content = textOf(bytes);
    const std::size_t end = content.rfind("endsolid");
    const std::size_t facet = content.rfind("endfacet");
    if (end == std::string_view::npos || (facet != std::string_view::npos && end < facet))
        refuse("expected endsolid at the end, found none: the file is truncated");
}

void checkStl(Bytes& bytes) {
    const std::string_view content = textOf(bytes);
    const bool exact = bytes.size() >= stlStart && binaryStlSize(bytes) == bytes.size();
    const bool looksLikeText = !exact && content.find('\0') == std::string_view::npos;
    if (looksLikeText) {
        const std::string_view start = trimmed(content).substr(0, 5);
        if (start == "solid" || start == "SOLID") return checkTextStl(bytes);
        refuse(fmt::format("expected STL, found {}", kindOf(content)));
    }
    if (bytes.size() < stlStart)
        refuse(fmt::format("expected an STL file of at least {} bytes, found {}", stlStart, bytes.size()));
    if (const std::uint64_t size = binaryStlSize(bytes); size > bytes.size())
        refuse(fmt::format("expected {} bytes for the {} triangles that the header says, found {}: the file is "
                           "truncated or no STL",
                           size, (size - stlStart) / stlTriangle, bytes.size()));
    bytes.resize(binaryStlSize(bytes));
    std::fill_n(bytes.begin(), stlHeader, std::uint8_t{0});
}

// ---- PLY

std::uint64_t sizeOfType(std::string_view type) {
    struct Type {
        std::string_view name;
        std::string_view otherName;
        std::uint64_t size;
    };
    constexpr std::array types{Type{"char", "int8", 1},    Type{"uchar", "uint8", 1},     Type{"short", "int16", 2},
                               Type{"ushort", "uint16", 2}, Type{"int", "int32", 4},       Type{"uint", "uint32", 4},
                               Type{"float", "float32", 4}, Type{"double", "float64", 8}};
    for (const Type& each : types)
        if (type == each.name || type == each.otherName) return each.size;
    refuse("expected a type of PLY in the header, found " + quote(type));
}

struct PlyElement {
    std::uint64_t count = 0;
    std::uint64_t size = 0;  // of one, at least; bytes
};

// What the header of a PLY file declares.
class PlyHeader {
public:
    explicit PlyHeader(std::string_view content) : rest_{content} {
        if (takeLine() != "ply") refuse(fmt::format("expected PLY, found {}", kindOf(content)));
        for (std::string_view line = takeLine(); line != "end_header"; line = takeLine()) readLine(line);
        if (!text_) refuse("expected a format in the header, found none");
    }

    // Elements take no less than this, and no element takes nothing: what only counts would not end.
    void checkSize() const {
        std::uint64_t left = rest_.size() + 1;  // the last line may do without its end
        for (const PlyElement& element : elements_) {
            const std::uint64_t size = std::max<std::uint64_t>(element.size, 1);
            if (element.count > left / size)
                refuse(fmt::format("expected {} elements of at least {} bytes, found {} bytes: the file is truncated",
                                   element.count, size, left - 1));
            left -= element.count * size;
        }
    }

private:
    std::string_view takeLine() {
        const std::size_t end = rest_.find_first_of("\r\n");
        if (end == std::string_view::npos) refuse("expected end_header, found the end of the file");
        const std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(end + (rest_.substr(end).starts_with("\r\n") ? 2 : 1));
        return line;
    }

    void readLine(std::string_view line) {
        const std::string_view keyword = takeWord(line);
        if (keyword == "format") readFormat(takeWord(line));
        if (keyword == "element") readElement(line);
        if (keyword == "property") readProperty(line);
    }

    void readFormat(std::string_view format) {
        text_ = format == "ascii";
        if (!*text_ && format != "binary_little_endian" && format != "binary_big_endian")
            refuse("expected format ascii, binary_little_endian or binary_big_endian, found " + quote(format));
    }

    void readElement(std::string_view line) {
        const std::string_view name = takeWord(line);
        const std::string_view number = takeWord(line);
        PlyElement element;
        const auto [end, failure] = std::from_chars(number.data(), number.data() + number.size(), element.count);
        if (failure != std::errc{} || end != number.data() + number.size())
            refuse(fmt::format("expected the number of {} in the header, found {}", quote(name), quote(number)));
        elements_.push_back(element);
    }

    void readProperty(std::string_view line) {
        if (elements_.empty()) refuse("expected an element before its properties, found none");
        const std::string_view type = takeWord(line);
        const std::uint64_t size = sizeOfType(type == "list" ? takeWord(line) : type);
        elements_.back().size += text_.value_or(false) ? 2 : size;  // in text a digit and a blank
    }

    std::string_view rest_;
    std::optional<bool> text_;
    std::vector<PlyElement> elements_;
};

}  // namespace

std::string_view name(PolygonFormat format) noexcept {
    switch (format) {
        case PolygonFormat::Obj:
            return "OBJ";
        case PolygonFormat::Stl:
            return "STL";
        case PolygonFormat::Ply:
            return "PLY";
    }
    return "";
}

void checkContent(PolygonFormat format, Bytes& bytes) {
    switch (format) {
        case PolygonFormat::Obj:
            return checkText(textOf(bytes), name(format));
        case PolygonFormat::Stl:
            return checkStl(bytes);
        case PolygonFormat::Ply:
            return PlyHeader{textOf(bytes)}.checkSize();
    }
}

}  // namespace inkedge::load
