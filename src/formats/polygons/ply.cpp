#include "formats/polygons/ply.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/message.h"
#include "base/read_file.h"
#include "formats/text.h"

namespace inkedge::polygons {
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
    std::optional<Type> length;            // of a list
    Type type;                             // of the number, or of a list's
    std::optional<std::size_t> slot = {};  // the index of its number in Numbers; none: not read, or a list
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
        base::refuse("expected format ascii, binary_little_endian or binary_big_endian, found " + base::quote(name));
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
    base::refuse("expected a type of PLY, found " + base::quote(name));
}

Element readElement(std::string_view line) {
    const std::string_view name = formats::takeWord(line);
    const std::string_view number = formats::takeWord(line);
    const std::optional<std::uint64_t> count = formats::toNumber<std::uint64_t>(number);
    if (!count || *count > std::numeric_limits<std::uint32_t>::max())
        base::refuse(
            fmt::format("expected the number of elements {}, found {}", base::quote(name), base::quote(number)));
    return {name, *count, {}};
}

Property readProperty(std::string_view line) {
    const std::string_view type = formats::takeWord(line);
    Property property;
    if (type == "list") {
        property.length = typeOf(formats::takeWord(line));
        if (!property.length->isInteger)
            base::refuse("expected an integer as a list's length, found " + base::quote(property.length->name));
    }
    property.type = typeOf(property.length ? formats::takeWord(line) : type);
    property.name = formats::takeWord(line);
    return property;
}

void readLine(std::string_view line, Header& header) {
    const std::string_view keyword = formats::takeWord(line);
    if (keyword == "format") {
        header.encoding = encodingOf(formats::takeWord(line));
    } else if (keyword == "element") {
        header.elements.push_back(readElement(line));
    } else if (keyword == "property") {
        if (header.elements.empty()) base::refuse("expected an element before its properties, found none");
        header.elements.back().properties.push_back(readProperty(line));
    } else if (!keyword.empty() && keyword != "comment" && keyword != "obj_info") {
        base::refuse("expected format, element, property, comment or end_header, found " + base::quote(keyword));
    }
}

// Reads the header and removes it from the content.
Header takeHeader(std::string_view& content) {
    const std::string_view whole = content;
    std::string_view line = takeLine(content);
    if (formats::takeWord(line) != "ply") base::refuse(fmt::format("expected PLY, found {}", base::kindOf(whole)));
    Header header;
    for (std::size_t number = 2;; ++number) {
        if (content.empty()) base::refuse("expected end_header, found the end of the file: it is truncated");
        line = takeLine(content);
        std::string_view words = line;
        if (formats::takeWord(words) == "end_header") return header;
        base::within(base::label("line", number), [&] { readLine(line, header); });
    }
}

bool isOneOf(std::string_view name, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

bool hasNumber(const Element& element, std::string_view name) {
    return std::ranges::any_of(element.properties, [&](const Property& p) { return p.name == name && !p.length; });
}

bool hasInteger(const Element& element, std::string_view name) {
    return std::ranges::any_of(element.properties,
                               [&](const Property& p) { return p.name == name && !p.length && p.type.isInteger; });
}

bool isIndexList(const Property& property) {
    return isOneOf(property.name, {"vertex_indices", "vertex_index"}) && property.length && property.type.isInteger;
}

bool isStrips(const Element& element) { return element.name == "tristrips"; }

bool isEdges(const Element& element) {
    return element.name == "edge" && hasInteger(element, "vertex1") && hasInteger(element, "vertex2");
}

bool isFaces(const Element& element) { return element.name == "face" || isStrips(element); }

// Whether a property is a texture coordinate, by its usual names. Lists per corner of a face are not read.
bool isTexture(const Property& property) {
    return !property.length && isOneOf(property.name, {"u", "s", "texture_u", "v", "t", "texture_v"});
}

// The numbers of a vertex that are read: its position, normal and texture coordinates.
using Numbers = std::array<double, 8>;
constexpr std::size_t firstOfNormal = 3;
constexpr std::size_t firstOfTexture = 6;

std::optional<std::size_t> slotOf(const Property& property, Coordinates coordinates) {
    if (property.length) return {};
    if (isTexture(property) && coordinates == Coordinates::Read)
        return isOneOf(property.name, {"u", "s", "texture_u"}) ? firstOfTexture : firstOfTexture + 1;
    constexpr std::array<std::string_view, firstOfTexture> names{"x", "y", "z", "nx", "ny", "nz"};
    const auto* const found = std::ranges::find(names, property.name);
    if (found == names.end()) return {};
    return static_cast<std::size_t>(found - names.begin());
}

void checkElement(const Element& element) {
    if (element.properties.empty()) base::refuse("expected properties, found none");
    if (element.name == "vertex")
        for (const char* coordinate : {"x", "y", "z"})
            if (!hasNumber(element, coordinate))
                base::refuse(fmt::format("expected the property {}, found none", coordinate));
    if (isFaces(element) && std::ranges::count_if(element.properties, isIndexList) != 1)
        base::refuse("expected one list vertex_indices of integers, found none or several");
}

void checkHeader(const Header& header) {
    if (!header.encoding) base::refuse("expected a format in the header, found none");
    bool hasVertices = false;
    bool hasFaces = false;
    for (const Element& element : header.elements) {
        base::within("element " + base::quote(element.name), [&] {
            bool* const has = element.name == "vertex" ? &hasVertices : (isFaces(element) ? &hasFaces : nullptr);
            if (has != nullptr && *has) base::refuse("expected it once, found it twice");
            if (has != nullptr) *has = true;
            checkElement(element);
        });
    }
    if (!hasVertices) base::refuse("expected elements 'vertex', found none");
}

// ---- the data

struct EndOfData {};

// Numbers in text, wherever lines end.
class TextData {
public:
    explicit TextData(std::string_view rest) : rest_{rest} {}

    std::uint64_t takeLength(const Type&) {
        const std::string_view word = nextWord();
        const std::optional<std::uint64_t> length = formats::toNumber<std::uint64_t>(word);
        if (!length) base::refuse("expected the length of a list, found " + base::quote(word));
        return *length;
    }
    std::int64_t takeInteger(const Type& type) { return take<std::int64_t>(type); }
    double takeNumber(const Type& type) {
        return type.isInteger ? static_cast<double>(takeInteger(type)) : take<double>(type);
    }
    void skip(const Type& type, std::uint64_t count) {
        for (; count > 0; --count) static_cast<void>(takeNumber(type));
    }

private:
    std::string_view nextWord() {
        const std::string_view word = formats::takeWord(rest_);
        if (word.empty()) throw EndOfData{};
        return word;
    }

    template <class Number>
    Number take(const Type& type) {
        const std::string_view word = nextWord();
        const std::optional<Number> number = formats::toNumber<Number>(word);
        if (!number) base::refuse(fmt::format("expected a number of type {}, found {}", type.name, base::quote(word)));
        return *number;
    }

    std::string_view rest_;
};

class BinaryData {
public:
    BinaryData(std::string_view rest, Encoding encoding) : rest_{rest}, isBigEndian_{encoding == Encoding::BigEndian} {}

    std::uint64_t takeLength(const Type& type) {
        const std::int64_t length = takeInteger(type);
        if (length < 0) base::refuse("expected the length of a list, found a negative number");
        return static_cast<std::uint64_t>(length);
    }
    std::int64_t takeInteger(const Type& type) {
        const std::uint64_t bits = takeBits(type.size);
        const std::uint64_t signBit = type.hasSign ? std::uint64_t{1} << (8 * type.size - 1) : 0;
        return static_cast<std::int64_t>((bits ^ signBit) - signBit);
    }
    double takeNumber(const Type& type) {
        if (type.isInteger) return static_cast<double>(takeInteger(type));
        const std::uint64_t bits = takeBits(type.size);
        if (type.size == 8) return std::bit_cast<double>(bits);
        return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
    }
    void skip(const Type& type, std::uint64_t count) { static_cast<void>(takeBytes(count * type.size)); }

private:
    std::string_view takeBytes(std::uint64_t size) {
        if (size > rest_.size()) throw EndOfData{};
        const std::string_view bytes = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return bytes;
    }

    std::uint64_t takeBits(std::uint64_t size) {
        const std::string_view bytes = takeBytes(size);
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i)
            bits = bits << 8 | static_cast<unsigned char>(bytes[isBigEndian_ ? i : size - 1 - i]);
        return bits;
    }

    std::string_view rest_;
    bool isBigEndian_;
};

// Indices that no vertex can have become the highest index, which is refused once the vertices are known.
std::uint32_t toIndex(std::int64_t number) {
    constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
    return number < 0 || number > std::int64_t{none} ? none : static_cast<std::uint32_t>(number);
}

template <class Data>
class PlyReader {
public:
    PlyReader(Data data, Coordinates coordinates, std::uint64_t maxElements)
        : data_{data}, coordinates_{coordinates}, maxElements_{maxElements} {}

    PolygonFile read(Header& header, bool finerThanFloat) {
        finerThanFloat_ = finerThanFloat;
        for (Element& element : header.elements) {
            if (element.name == "vertex") prepareVertices(element);
            for (std::uint64_t i = 0; i < element.count; ++i) {
                try {
                    readElement(element);
                } catch (const EndOfData&) {
                    base::refuse(fmt::format("expected {} elements {}, found data for {}: the file is truncated",
                                             element.count, base::quote(element.name), i));
                }
            }
        }
        if (file_.faceCount == 0 && file_.lines.empty()) file_.points += vertexCount_;
        return std::move(file_);
    }

private:
    void prepareVertices(Element& element) {
        vertexCount_ = element.count;
        for (Property& property : element.properties) {
            property.slot = slotOf(property, coordinates_);
            hasNormals_ =
                hasNormals_ || (property.slot && *property.slot >= firstOfNormal && *property.slot < firstOfTexture);
            hasTexture_ = hasTexture_ || (property.slot && *property.slot >= firstOfTexture);
        }
    }

    void readElement(const Element& element) {
        if (element.name == "vertex") return readVertex(element);
        if (isEdges(element)) return readEdge(element);
        for (const Property& property : element.properties) {
            if (isFaces(element) && isIndexList(property))
                isStrips(element) ? readStrip(property) : readFace(property);
            else
                skip(property);
        }
    }

    void skip(const Property& property) {
        data_.skip(property.type, property.length ? data_.takeLength(*property.length) : 1);
    }

    void readVertex(const Element& element) {
        Numbers numbers{};
        for (const Property& property : element.properties) {
            if (property.slot)
                numbers[*property.slot] = data_.takeNumber(property.type);
            else
                skip(property);
        }
        const auto [x, y, z, nx, ny, nz, u, v] = numbers;
        if (finerThanFloat_)
            file_.finePositions.emplace_back(x, y, z);
        else
            file_.positions.emplace_back(x, y, z);
        if (hasNormals_) file_.normals.emplace_back(nx, ny, nz);
        if (hasTexture_) file_.textureCoordinates.emplace_back(u, 1.0F - static_cast<float>(v));
    }

    void readFace(const Property& property) {
        const std::uint64_t length = data_.takeLength(*property.length);
        expectRoomFor(length);
        for (std::uint64_t i = 0; i < length; ++i) file_.corners.push_back(toIndex(data_.takeInteger(property.type)));
        file_.endFace(length);
    }

    void readEdge(const Element& element) {
        std::array<std::uint32_t, 2> ends{};
        for (const Property& property : element.properties) {
            if (!property.length && isOneOf(property.name, {"vertex1", "vertex2"}))
                ends[property.name == "vertex1" ? 0 : 1] = toIndex(data_.takeInteger(property.type));
            else
                skip(property);
        }
        file_.lines.insert(file_.lines.end(), ends.begin(), ends.end());
    }

    // Every index from the third on makes a triangle with the two before it. -1 ends a strip and starts a new one.
    void readStrip(const Property& property) {
        std::array<std::uint32_t, 2> last{};
        std::uint64_t count = 0;
        for (std::uint64_t length = data_.takeLength(*property.length); length > 0; --length) {
            const std::int64_t index = data_.takeInteger(property.type);
            if (index < -1 || index > std::numeric_limits<std::int32_t>::max())
                base::refuse(fmt::format("expected vertices from 0, or -1 between strips, found {}", index));
            if (index == -1) {
                count = 0;
                continue;
            }
            const std::uint32_t vertex = toIndex(index);
            if (++count >= 3) {
                expectRoomFor(3);
                const std::size_t first = count % 2 == 0 ? 1 : 0;  // every second triangle runs the other way
                file_.corners.insert(file_.corners.end(), {last[first], last[1 - first], vertex});
                file_.endFace(3);
            }
            last = {last[1], vertex};
        }
    }

    void expectRoomFor(std::uint64_t corners) const {
        expectWithin(vertexCount_ + file_.corners.size() + std::min(corners, maxElements_), maxElements_);
    }

    Data data_;
    Coordinates coordinates_;
    std::uint64_t maxElements_;
    bool finerThanFloat_ = false;
    bool hasNormals_ = false;
    bool hasTexture_ = false;
    std::uint64_t vertexCount_ = 0;
    PolygonFile file_;
};

bool hasDoubles(const Header& header) {
    return std::ranges::any_of(header.elements, [](const Element& element) {
        return element.name == "vertex" && std::ranges::any_of(element.properties, [](const Property& p) {
                   return isOneOf(p.name, {"x", "y", "z"}) && p.type.size == 8;
               });
    });
}

// By what the header says; a face has at least three corners.
void expectHeaderWithin(const Header& header, std::uint64_t maxElements) {
    std::uint64_t elements = 0;
    for (const Element& element : header.elements) {
        if (element.name == "vertex") elements += element.count;
        if (element.name == "face") elements += 3 * element.count;
    }
    expectWithin(elements, maxElements);
}

}  // namespace

PolygonFile readPly(std::string_view content, Coordinates coordinates, std::uint64_t maxElements) {
    content = formats::withoutByteOrderMark(content);
    Header header = takeHeader(content);
    checkHeader(header);
    expectHeaderWithin(header, maxElements);
    if (header.encoding == Encoding::Text)
        return PlyReader{TextData{content}, coordinates, maxElements}.read(header, true);
    return PlyReader{BinaryData{content, *header.encoding}, coordinates, maxElements}.read(header, hasDoubles(header));
}

void expectPlyWithin(std::string_view start, std::uint64_t maxElements) {
    if (start.find("end_header") == std::string_view::npos) return;
    start = formats::withoutByteOrderMark(start);
    const Header header = takeHeader(start);
    checkHeader(header);
    expectHeaderWithin(header, maxElements);
}

}  // namespace inkedge::polygons
