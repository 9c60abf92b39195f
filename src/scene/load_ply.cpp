#include "scene/load_ply.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "scene/load_file.h"
#include "scene/load_message.h"
#include "scene/load_text.h"

namespace inkedge::load {
namespace {

enum class PlyEncoding { Text, LittleEndian, BigEndian };

struct PlyType {
    std::string_view name;
    std::string_view otherName;
    std::uint64_t size = 0;  // bytes
    bool counts = false;     // is an integer
    bool hasSign = false;
};

PlyType plyType(std::string_view name) {
    constexpr std::array types{
        PlyType{"char", "int8", 1, true, true},    PlyType{"uchar", "uint8", 1, true, false},
        PlyType{"short", "int16", 2, true, true},  PlyType{"ushort", "uint16", 2, true, false},
        PlyType{"int", "int32", 4, true, true},    PlyType{"uint", "uint32", 4, true, false},
        PlyType{"float", "float32", 4},            PlyType{"double", "float64", 8},
    };
    for (const PlyType& type : types)
        if (name == type.name || name == type.otherName) return type;
    refuse("expected a type of PLY in the header, found " + quote(name));
}

struct PlyProperty {
    std::optional<PlyType> length;  // of a list
    PlyType type;                   // of the number, or of a list's
};

struct PlyElement {
    std::string_view name;
    std::uint64_t count = 0;
    std::vector<PlyProperty> properties;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Text;
    std::vector<PlyElement> elements;
};

[[noreturn]] void refuseTruncatedPly(const PlyElement& element, std::uint64_t found) {
    refuse(fmt::format("expected {} elements {}, found data for {}: the file is truncated", element.count,
                       quote(element.name), found));
}

std::string_view takeLine(std::string_view& rest) {
    const std::size_t end = rest.find_first_of("\r\n");
    if (end == std::string_view::npos) refuse("expected end_header, found the end of the file");
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end + (rest.substr(end).starts_with("\r\n") ? 2 : 1));
    return line;
}

PlyEncoding plyEncoding(std::string_view name) {
    if (name == "ascii") return PlyEncoding::Text;
    if (name == "binary_little_endian") return PlyEncoding::LittleEndian;
    if (name == "binary_big_endian") return PlyEncoding::BigEndian;
    refuse("expected format ascii, binary_little_endian or binary_big_endian, found " + quote(name));
}

PlyElement plyElement(std::string_view line) {
    const std::string_view name = takeWord(line);
    const std::string_view number = takeWord(line);
    const std::optional<std::uint64_t> count = toNumber<std::uint64_t>(number);
    if (!count || *count > std::numeric_limits<std::uint32_t>::max())
        refuse(fmt::format("expected the number of {} in the header, found {}", quote(name), quote(number)));
    return {name, *count, {}};
}

PlyProperty plyProperty(std::string_view line) {
    const std::string_view type = takeWord(line);
    if (type != "list") return {{}, plyType(type)};
    const PlyType length = plyType(takeWord(line));
    if (!length.counts) refuse("expected an integer as a list's length, found " + quote(length.name));
    return {length, plyType(takeWord(line))};
}

// Takes the header off the content.
PlyHeader takePlyHeader(std::string_view& content) {
    const std::string_view kind = kindOf(content);
    if (!content.starts_with("ply") || !trimmed(takeLine(content).substr(3)).empty())
        refuse(fmt::format("expected PLY, found {}", kind));
    PlyHeader header;
    for (std::string_view line = takeLine(content); !line.starts_with("end_header"); line = takeLine(content)) {
        const std::string_view keyword = takeWord(line);
        if (keyword == "format") header.encoding = plyEncoding(takeWord(line));
        if (keyword == "element") header.elements.push_back(plyElement(line));
        if (keyword != "property") continue;
        if (header.elements.empty()) refuse("expected an element before its properties, found none");
        header.elements.back().properties.push_back(plyProperty(line));
    }
    return header;
}

// The data of a text PLY: as many numbers as the header and the lists say.
class PlyText {
public:
    explicit PlyText(std::string_view rest) : rest_{rest} {}

    bool skip(const PlyProperty& property) {
        const std::optional<std::uint64_t> count = property.length ? toNumber<std::uint64_t>(takeWord(rest_)) : 1;
        for (std::uint64_t i = 0; count && i < *count; ++i)
            if (takeWord(rest_).empty()) return false;
        return count.has_value();
    }

private:
    std::string_view rest_;
};

// The same of a binary one.
class PlyBinary {
public:
    PlyBinary(std::string_view rest, PlyEncoding encoding) : rest_{rest}, encoding_{encoding} {}

    bool skip(const PlyProperty& property) {
        if (!property.length) return skipBytes(property.type.size);
        const std::optional<std::uint64_t> length = takeLength(*property.length);
        return length && skipBytes(*length * property.type.size);
    }

private:
    bool skipBytes(std::uint64_t size) {
        if (size > rest_.size()) return false;
        rest_.remove_prefix(size);
        return true;
    }

    std::optional<std::uint64_t> takeLength(const PlyType& type) {
        if (type.size > rest_.size()) return {};
        std::uint64_t length = 0;
        for (std::uint64_t i = 0; i < type.size; ++i) {
            const std::uint64_t place = encoding_ == PlyEncoding::BigEndian ? type.size - 1 - i : i;
            length |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * place);
        }
        rest_.remove_prefix(type.size);
        if (type.hasSign && length >> (8 * type.size - 1) != 0) return {};
        return length;
    }

    std::string_view rest_;
    PlyEncoding encoding_;
};

template <class Data>
void walk(const PlyHeader& header, Data data) {
    for (const PlyElement& element : header.elements) {
        if (element.properties.empty() && element.count > 0)
            refuse(fmt::format("expected properties of the elements {}, found none", quote(element.name)));
        for (std::uint64_t i = 0; i < element.count; ++i)
            for (const PlyProperty& property : element.properties)
                if (!data.skip(property)) refuseTruncatedPly(element, i);
    }
}

}  // namespace

void checkPly(std::string_view content) {
    const PlyHeader header = takePlyHeader(content);
    if (header.encoding == PlyEncoding::Text)
        walk(header, PlyText{content});
    else
        walk(header, PlyBinary{content, header.encoding});
}

}  // namespace inkedge::load
