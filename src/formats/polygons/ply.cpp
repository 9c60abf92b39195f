#include "formats/polygons/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/read_file.h"
#include "base/message.h"
#include "formats/text.h"

namespace inkedge::load {
namespace {

// ---- the header

constexpr std::array encodings{std::string_view{"ascii"}, std::string_view{"binary_little_endian"},
                               std::string_view{"binary_big_endian"}};
enum class Encoding { Text, LittleEndian, BigEndian };  // in that order

struct Type {
    std::string_view name;
    std::string_view otherName;
    std::uint64_t size = 0;  // bytes
    bool isInteger = false;
    bool hasSign = false;
};

struct Property {
    std::string_view name;
    std::optional<Type> length;  // of a list
    Type type;                   // of the number, or of a list's
    bool isUsed = false;         // bears on the shape
    double origin = 0.0;         // taken off its numbers, which become doubles if it is not 0
};

struct Element {
    std::string_view name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    std::optional<Encoding> encoding;
    std::vector<Element> elements;
};

std::string_view takeLine(std::string_view& rest) {
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end);
    rest.remove_prefix(rest.starts_with("\r\n") ? 2 : std::min<std::size_t>(rest.size(), 1));
    return line;
}

Encoding encodingOf(std::string_view name) {
    const auto* const known = std::ranges::find(encodings, name);
    if (known == encodings.end())
        refuse("expected format ascii, binary_little_endian or binary_big_endian, found " + quote(name));
    return static_cast<Encoding>(known - encodings.begin());
}

Type typeOf(std::string_view name) {
    constexpr std::array types{
        Type{"char", "int8", 1, true, true},      Type{"uchar", "uint8", 1, true, false},
        Type{"short", "int16", 2, true, true},    Type{"ushort", "uint16", 2, true, false},
        Type{"int", "int32", 4, true, true},      Type{"uint", "uint32", 4, true, false},
        Type{"float", "float32", 4, false, true}, Type{"double", "float64", 8, false, true},
    };
    for (const Type& type : types)
        if (name == type.name || name == type.otherName) return type;
    refuse("expected a type of PLY, found " + quote(name));
}

Element readElement(std::string_view line) {
    const std::string_view name = takeWord(line);
    const std::string_view number = takeWord(line);
    const std::optional<std::uint64_t> count = toNumber<std::uint64_t>(number);
    if (!count || *count > std::numeric_limits<std::uint32_t>::max())
        refuse(fmt::format("expected the number of elements {}, found {}", quote(name), quote(number)));
    return {name, *count, {}};
}

Property readProperty(std::string_view line) {
    const std::string_view type = takeWord(line);
    Property property;
    if (type == "list") {
        property.length = typeOf(takeWord(line));
        if (!property.length->isInteger)
            refuse("expected an integer as a list's length, found " + quote(property.length->name));
    }
    property.type = typeOf(property.length ? takeWord(line) : type);
    property.name = takeWord(line);
    return property;
}

void readLine(std::string_view line, Header& header) {
    const std::string_view keyword = takeWord(line);
    if (keyword == "format") {
        header.encoding = encodingOf(takeWord(line));
    } else if (keyword == "element") {
        header.elements.push_back(readElement(line));
    } else if (keyword == "property") {
        if (header.elements.empty()) refuse("expected an element before its properties, found none");
        header.elements.back().properties.push_back(readProperty(line));
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        refuse("expected format, element, property, comment or end_header, found " + quote(keyword));
    }
}

// Takes the header off the content.
Header takeHeader(std::string_view& content) {
    const std::string_view whole = content;
    std::string_view line = takeLine(content);
    if (takeWord(line) != "ply") refuse(fmt::format("expected PLY, found {}", kindOf(whole)));
    Header header;
    for (std::size_t number = 2;; ++number) {
        if (content.empty()) refuse("expected end_header, found the end of the file: it is truncated");
        line = takeLine(content);
        std::string_view words = line;
        if (takeWord(words) == "end_header") return header;
        within(label("line", number), [&] { readLine(line, header); });
    }
}

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

bool hasNumber(const Element& element, std::string_view name) {
    return std::ranges::any_of(element.properties, [&](const Property& p) { return p.name == name && !p.length; });
}

bool isIndexList(const Property& property) {
    return isOneOf(property.name, {"vertex_indices", "vertex_index"}) && property.length && property.type.isInteger;
}

bool isStrips(const Element& element) { return element.name == "tristrips"; }

bool isFaces(const Element& element) { return element.name == "face" || isStrips(element); }

bool isPosition(const Property& property) { return isOneOf(property.name, {"x", "y", "z"}); }

// By the names that assimp knows; lists of a face's corners are not read.
bool isTexture(const Property& property) {
    return !property.length && isOneOf(property.name, {"u", "s", "texture_u", "v", "t", "texture_v"});
}

bool isUsed(const Element& element, const Property& property, Coordinates coordinates) {
    if (element.name == "vertex" && coordinates == Coordinates::Read && isTexture(property)) return true;
    if (element.name == "vertex") return !property.length && isOneOf(property.name, {"x", "y", "z", "nx", "ny", "nz"});
    return isFaces(element) && isIndexList(property);
}

bool hasDoubles(const Header& header) {
    return std::ranges::any_of(header.elements, [](const Element& element) {
        return element.name == "vertex" && std::ranges::any_of(element.properties, [](const Property& p) {
                   return isOneOf(p.name, {"x", "y", "z"}) && p.type.size == 8;
               });
    });
}

void checkElement(const Element& element) {
    if (element.properties.empty()) refuse("expected properties, found none");
    if (element.name == "vertex")
        for (const char* coordinate : {"x", "y", "z"})
            if (!hasNumber(element, coordinate))
                refuse(fmt::format("expected the property {}, found none", coordinate));
    if (isFaces(element) && std::ranges::count_if(element.properties, isIndexList) != 1)
        refuse("expected one list vertex_indices of integers, found none or several");
}

void checkHeader(const Header& header) {
    if (!header.encoding) refuse("expected a format in the header, found none");
    bool hasVertices = false;
    bool hasFaces = false;
    for (const Element& element : header.elements) {
        within("element " + quote(element.name), [&] {
            bool* const has = element.name == "vertex" ? &hasVertices : (isFaces(element) ? &hasFaces : nullptr);
            if (has == &hasFaces && !hasVertices) refuse("expected it after the vertices, found it before");
            if (has != nullptr && *has) refuse("expected it once, found it twice");
            if (has != nullptr) *has = true;
            checkElement(element);
        });
    }
    if (!hasVertices) refuse("expected elements 'vertex', found none");
}

// ---- what is passed on

void append(Bytes& bytes, std::string_view text) { bytes.insert(bytes.end(), text.begin(), text.end()); }

// Triangle strips are cut into faces: assimp keeps the last triangle of each and leaks the others.
std::string headerText(const Header& header, std::uint64_t stripTriangles) {
    std::string text = fmt::format("ply\nformat {} 1.0\n", encodings[static_cast<std::size_t>(*header.encoding)]);
    for (const Element& element : header.elements) {
        if (isStrips(element)) {
            text += fmt::format("element face {}\nproperty list uchar int vertex_indices\n", stripTriangles);
            continue;
        }
        if (element.name != "vertex" && !isFaces(element)) continue;
        text += fmt::format("element {} {}\n", element.name, element.count);
        for (const Property& property : element.properties) {
            if (!property.isUsed) continue;
            const std::string list = property.length ? fmt::format("list {} ", property.length->name) : "";
            text += fmt::format("property {}{} {}\n", list, property.origin == 0.0 ? property.type.name : "double",
                                property.length ? "vertex_indices" : property.name);
        }
    }
    return text + "end_header\n";
}

using Corners = std::array<std::uint32_t, 3>;

// Calls add() for each triangle of a strip. An index of -1 ends a strip and starts another.
template <class Add>
void cutStrip(std::span<const std::int64_t> strip, Add&& add) {
    std::vector<std::uint32_t> run;
    for (const std::int64_t index : strip) {
        if (index < -1 || index > std::numeric_limits<std::int32_t>::max())
            refuse(fmt::format("expected vertices from 0, or -1 between strips, found {}", index));
        if (index == -1) {
            run.clear();
            continue;
        }
        run.push_back(static_cast<std::uint32_t>(index));
        const std::size_t end = run.size();
        if (end < 3) continue;
        const std::size_t odd = end % 2 == 0 ? 1 : 0;  // every second triangle runs the other way
        add(Corners{run[end - 3 + odd], run[end - 2 - odd], run[end - 1]});
    }
}

[[noreturn]] void refuseEnd(const Element& element, std::uint64_t found) {
    refuse(fmt::format("expected {} elements {}, found data for {}: the file is truncated", element.count,
                       quote(element.name), found));
}

// Numbers in text: one element a line.
class TextData {
public:
    TextData(std::string_view rest, Bytes& out) : rest_{rest}, out_{out} {}

    // False at the end of the data.
    bool readElement(const Element& element) {
        const auto pass = [&](const Property& property, std::string_view word) {
            if (property.origin == 0.0)
                append(out_, word);
            else
                append(out_, fmt::format("{}", *toNumber<double>(word) - property.origin));
            append(out_, " ");
        };
        if (!read(element, pass, pass)) return false;
        if (element.name == "vertex" || isFaces(element)) append(out_, "\n");
        return true;
    }

    // The same, of strips: their indices are added to a list.
    bool readStrip(const Element& element, std::vector<std::int64_t>& strip) {
        const auto add = [&](const Property&, std::string_view word) {
            strip.push_back(*toNumber<std::int64_t>(word));
        };
        return read(
            element, [](const Property&, std::string_view) {}, add);
    }

    void addFace(const Corners& c) { append(out_, fmt::format("3 {} {} {}\n", c[0], c[1], c[2])); }

    void finish() {}

private:
    // Hands the words of used properties on: the lengths of lists, and numbers.
    template <class TakeLength, class TakeNumber>
    bool read(const Element& element, TakeLength&& takeLength, TakeNumber&& takeNumber) {
        for (const Property& property : element.properties) {
            std::uint64_t count = 1;
            if (property.length) {
                const std::string_view word = takeWord(rest_);
                if (word.empty()) return false;
                const std::optional<std::uint64_t> length = toNumber<std::uint64_t>(word);
                if (!length) refuse("expected the length of a list, found " + quote(word));
                count = *length;
                if (property.isUsed) takeLength(property, word);
            }
            for (; count > 0; --count) {
                const std::string_view word = takeWord(rest_);
                if (word.empty()) return false;
                if (property.type.isInteger ? !toNumber<std::int64_t>(word) : !toNumber<double>(word))
                    refuse(fmt::format("expected a number of type {}, found {}", property.type.name, quote(word)));
                if (property.isUsed) takeNumber(property, word);
            }
        }
        return true;
    }

    std::string_view rest_;
    Bytes& out_;
};

// Numbers in binary: passed on as they are, in runs as long as can be.
class BinaryData {
public:
    BinaryData(std::string_view rest, Bytes& out, Encoding encoding)
        : rest_{rest}, run_{rest}, out_{out}, encoding_{encoding} {}

    // False at the end of the data.
    bool readElement(const Element& element) {
        return std::ranges::all_of(element.properties, [&](const Property& property) {
            if (property.isUsed && property.origin == 0.0) return skipProperty(property);
            finish();
            const bool read = property.isUsed ? passLessOrigin(property) : skipProperty(property);
            run_ = rest_;
            return read;
        });
    }

    // The same, of strips: their indices are added to a list.
    bool readStrip(const Element& element, std::vector<std::int64_t>& strip) {
        finish();
        const bool read = std::ranges::all_of(element.properties, [&](const Property& property) {
            return property.isUsed ? readList(property, strip) : skipProperty(property);
        });
        run_ = rest_;
        return read;
    }

    void addFace(const Corners& corners) {
        out_.push_back(3);
        for (const std::uint32_t corner : corners)
            for (std::uint64_t i = 0; i < 4; ++i)
                out_.push_back(static_cast<std::uint8_t>(corner >> (8 * placeOf(i, 4)) & 255));
    }

    // Passes on the run so far.
    void finish() {
        append(out_, run_.substr(0, run_.size() - rest_.size()));
        run_ = rest_;
    }

private:
    bool skipProperty(const Property& property) {
        if (!property.length) return skip(property.type.size);
        const std::optional<std::uint64_t> length = takeLength(*property.length);
        return length && skip(*length * property.type.size);
    }

    bool readList(const Property& property, std::vector<std::int64_t>& list) {
        const std::optional<std::uint64_t> length = takeLength(*property.length);
        if (!length || *length * property.type.size > rest_.size()) return false;
        for (std::uint64_t i = 0; i < *length; ++i) list.push_back(*takeInteger(property.type));
        return true;
    }

    bool passLessOrigin(const Property& property) {
        const std::optional<std::uint64_t> bits = takeBits(property.type.size);
        if (!bits) return false;
        const double number = numberOf(*bits, property.type) - property.origin;
        const auto shifted = std::bit_cast<std::uint64_t>(number);
        for (std::uint64_t i = 0; i < 8; ++i)
            out_.push_back(static_cast<std::uint8_t>(shifted >> (8 * placeOf(i, 8)) & 255));
        return true;
    }

    static double numberOf(std::uint64_t bits, const Type& type) {
        if (type.isInteger) return static_cast<double>(integerOf(bits, type));
        if (type.size == 8) return std::bit_cast<double>(bits);
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }

    static std::int64_t integerOf(std::uint64_t bits, const Type& type) {
        const std::uint64_t signBit = type.hasSign ? std::uint64_t{1} << (8 * type.size - 1) : 0;
        return static_cast<std::int64_t>((bits ^ signBit) - signBit);
    }

    bool skip(std::uint64_t size) {
        if (size > rest_.size()) return false;
        rest_.remove_prefix(size);
        return true;
    }

    std::optional<std::uint64_t> takeLength(const Type& type) {
        const std::optional<std::int64_t> length = takeInteger(type);
        if (!length) return {};
        if (*length < 0) refuse("expected the length of a list, found a negative number");
        return static_cast<std::uint64_t>(*length);
    }

    std::optional<std::int64_t> takeInteger(const Type& type) {
        const std::optional<std::uint64_t> bits = takeBits(type.size);
        if (!bits) return {};
        return integerOf(*bits, type);
    }

    std::optional<std::uint64_t> takeBits(std::uint64_t size) {
        if (size > rest_.size()) return {};
        std::uint64_t bits = 0;
        for (std::uint64_t i = 0; i < size; ++i)
            bits |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * placeOf(i, size));
        rest_.remove_prefix(size);
        return bits;
    }

    // The weight of byte i of a number.
    std::uint64_t placeOf(std::uint64_t i, std::uint64_t size) const {
        return encoding_ == Encoding::BigEndian ? size - 1 - i : i;
    }

    std::string_view rest_;
    std::string_view run_;  // what is still to be passed on, and the rest
    Bytes& out_;
    Encoding encoding_;
};

// The number of faces that strips were cut into.
template <class Data>
std::uint64_t readData(const Header& header, Data data) {
    std::uint64_t cut = 0;
    std::vector<std::int64_t> strip;
    const auto readStrip = [&](const Element& element) {
        strip.clear();
        if (!data.readStrip(element, strip)) return false;
        cutStrip(strip, [&](const Corners& corners) {
            data.addFace(corners);
            ++cut;
        });
        return true;
    };
    for (const Element& element : header.elements)
        for (std::uint64_t i = 0; i < element.count; ++i)
            if (!(isStrips(element) ? readStrip(element) : data.readElement(element))) refuseEnd(element, i);
    data.finish();
    return cut;
}

}  // namespace

PlyContent safePly(std::string_view content, const glm::dvec3& origin, Coordinates coordinates) {
    const std::size_t size = content.size();
    Header header = takeHeader(content);
    checkHeader(header);
    for (Element& element : header.elements)
        for (Property& property : element.properties) {
            property.isUsed = isUsed(element, property, coordinates);
            if (element.name == "vertex" && property.isUsed && isPosition(property))
                property.origin = origin[property.name[0] - 'x'];
        }
    Bytes bytes;
    bytes.reserve(size + size / 8 + 1024);
    const std::uint64_t cut = header.encoding == Encoding::Text
                                  ? readData(header, TextData{content, bytes})
                                  : readData(header, BinaryData{content, bytes, *header.encoding});
    const std::string start = headerText(header, cut);
    bytes.insert(bytes.begin(), start.begin(), start.end());
    return {std::move(bytes), header.encoding == Encoding::Text || hasDoubles(header)};
}

}  // namespace inkedge::load
