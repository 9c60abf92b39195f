#include "scene/load_ply.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "scene/load_file.h"
#include "scene/load_message.h"
#include "scene/load_text.h"

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

bool isFaces(const Element& element) { return isOneOf(element.name, {"face", "tristrips"}); }

bool isUsed(const Element& element, const Property& property) {
    if (element.name == "vertex") return !property.length && isOneOf(property.name, {"x", "y", "z", "nx", "ny", "nz"});
    return isFaces(element) && isIndexList(property);
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

void appendHeader(Bytes& bytes, const Header& header) {
    append(bytes, fmt::format("ply\nformat {} 1.0\n", encodings[static_cast<std::size_t>(*header.encoding)]));
    for (const Element& element : header.elements) {
        if (element.name != "vertex" && !isFaces(element)) continue;
        append(bytes, fmt::format("element {} {}\n", element.name, element.count));
        for (const Property& property : element.properties) {
            if (!property.isUsed) continue;
            const std::string list = property.length ? fmt::format("list {} ", property.length->name) : "";
            append(bytes, fmt::format("property {}{} {}\n", list, property.type.name,
                                      property.length ? "vertex_indices" : property.name));
        }
    }
    append(bytes, "end_header\n");
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
        for (const Property& property : element.properties) {
            std::uint64_t count = 1;
            if (property.length) {
                const std::string_view word = takeWord(rest_);
                if (word.empty()) return false;
                const std::optional<std::uint64_t> length = toNumber<std::uint64_t>(word);
                if (!length) refuse("expected the length of a list, found " + quote(word));
                count = *length;
                pass(word, property);
            }
            for (; count > 0; --count)
                if (!readNumber(property)) return false;
        }
        if (element.name == "vertex" || isFaces(element)) append(out_, "\n");
        return true;
    }

    void finish() {}

private:
    bool readNumber(const Property& property) {
        const std::string_view word = takeWord(rest_);
        if (word.empty()) return false;
        if (property.type.isInteger ? !toNumber<std::int64_t>(word) : !toNumber<double>(word))
            refuse(fmt::format("expected a number of type {}, found {}", property.type.name, quote(word)));
        pass(word, property);
        return true;
    }

    void pass(std::string_view word, const Property& property) {
        if (!property.isUsed) return;
        append(out_, word);
        append(out_, " ");
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
            if (!property.isUsed) finish();
            const bool read = skipProperty(property);
            if (!property.isUsed) run_ = rest_;
            return read;
        });
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

    bool skip(std::uint64_t size) {
        if (size > rest_.size()) return false;
        rest_.remove_prefix(size);
        return true;
    }

    std::optional<std::uint64_t> takeLength(const Type& type) {
        if (type.size > rest_.size()) return {};
        std::uint64_t length = 0;
        for (std::uint64_t i = 0; i < type.size; ++i) {
            const std::uint64_t place = encoding_ == Encoding::BigEndian ? type.size - 1 - i : i;
            length |= std::uint64_t{static_cast<unsigned char>(rest_[i])} << (8 * place);
        }
        rest_.remove_prefix(type.size);
        if (type.hasSign && length >> (8 * type.size - 1) != 0)
            refuse("expected the length of a list, found a negative number");
        return length;
    }

    std::string_view rest_;
    std::string_view run_;  // what is still to be passed on, and the rest
    Bytes& out_;
    Encoding encoding_;
};

template <class Data>
void readData(const Header& header, Data data) {
    for (const Element& element : header.elements)
        for (std::uint64_t i = 0; i < element.count; ++i)
            if (!data.readElement(element)) refuseEnd(element, i);
    data.finish();
}

}  // namespace

Bytes safePly(std::string_view content) {
    const std::size_t size = content.size();
    Header header = takeHeader(content);
    checkHeader(header);
    for (Element& element : header.elements)
        for (Property& property : element.properties) property.isUsed = isUsed(element, property);
    Bytes bytes;
    bytes.reserve(size + size / 8 + 1024);
    appendHeader(bytes, header);
    if (header.encoding == Encoding::Text)
        readData(header, TextData{content, bytes});
    else
        readData(header, BinaryData{content, bytes, *header.encoding});
    return bytes;
}

}  // namespace inkedge::load
