#include "formats/polygons/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "base/read_file.h"
#include "base/message.h"
#include "formats/text.h"

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

void append(Bytes& bytes, std::uint32_t word) {
    for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<std::uint8_t>(word >> (8 * i) & 0xff));
}

// Writers differ in case.
bool is(std::string_view word, std::string_view lowerCase) {
    return std::ranges::equal(word, lowerCase, [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

// Turns text into the data of a binary file.
class TextReader {
public:
    explicit TextReader(std::string_view content) : rest_{content} { binary_.resize(dataStart); }

    Bytes read() {
        for (std::string_view word = takeWord(rest_); !word.empty(); word = takeWord(rest_)) {
            if (!is(word, "solid")) refuse("expected solid or the end of the file, found " + quote(word));
            skipLine();
            readSolid();
        }
        const auto triangles = static_cast<std::uint32_t>((binary_.size() - dataStart) / triangleSize);
        for (std::size_t i = 0; i < 4; ++i) binary_[headerSize + i] = static_cast<std::uint8_t>(triangles >> (8 * i));
        return std::move(binary_);
    }

private:
    void readSolid() {
        for (;; ++facet_) {
            const std::string_view word = nextWord();
            if (is(word, "endsolid")) return skipLine();
            within(label("facet", facet_), [&] { readFacet(word); });
        }
    }

    void readFacet(std::string_view first) {
        if (!is(first, "facet")) refuse("expected facet or endsolid, found " + quote(first));
        expect("normal");
        for (int i = 0; i < 3; ++i) static_cast<void>(nextWord());
        for (int i = 0; i < 3; ++i) append(binary_, 0);
        expect("outer");
        expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            for (int i = 0; i < 3; ++i) append(binary_, std::bit_cast<std::uint32_t>(nextNumber()));
        }
        expect("endloop");
        expect("endfacet");
        binary_.insert(binary_.end(), {0, 0});
    }

    void expect(std::string_view word) {
        if (const std::string_view found = nextWord(); !is(found, word))
            refuse(fmt::format("expected {}, found {}", word, quote(found)));
    }

    float nextNumber() {
        const std::string_view word = nextWord();
        const std::optional<double> number = toNumber<double>(word);
        if (!number || !(std::abs(*number) <= std::numeric_limits<float>::max()))
            refuse("expected a finite number, found " + quote(word));
        return static_cast<float>(*number);
    }

    std::string_view nextWord() {
        const std::string_view word = takeWord(rest_);
        if (word.empty()) refuse("expected endsolid, found the end of the file: it is truncated");
        return word;
    }

    void skipLine() { rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size())); }

    std::string_view rest_;
    std::size_t facet_ = 0;
    Bytes binary_;
};

}  // namespace

Bytes safeStl(Bytes bytes) {
    const std::string_view content = textOf(bytes);
    const bool exact = bytes.size() >= dataStart && binarySize(bytes) == bytes.size();
    const bool isText = !exact && content.find('\0') == std::string_view::npos;
    if (isText) {
        if (!is(trimmed(content).substr(0, 5), "solid")) refuse(fmt::format("expected STL, found {}", kindOf(content)));
        return TextReader{content}.read();
    }
    if (bytes.size() < dataStart)
        refuse(fmt::format("expected an STL file of at least {} bytes, found {}", dataStart, bytes.size()));
    if (const std::uint64_t size = binarySize(bytes); size > bytes.size())
        refuse(
            fmt::format("expected {} bytes for the {} triangles that the header says, found {}: the file is "
                        "truncated or no STL",
                        size, (size - dataStart) / triangleSize, bytes.size()));
    bytes.resize(binarySize(bytes));
    std::fill_n(bytes.begin(), headerSize, std::uint8_t{0});
    return bytes;
}

}  // namespace inkedge::load
