#include "formats/polygons/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "base/message.h"
#include "base/read_file.h"
#include "formats/text.h"

namespace inkedge::polygons {
namespace {

using ByteSpan = std::span<const std::uint8_t>;

constexpr std::size_t headerSize = 80;
constexpr std::size_t dataStart = headerSize + 4;  // after the number of triangles
constexpr std::size_t triangleSize = 50;
constexpr std::size_t normalSize = 12;
constexpr std::uint64_t elementsPerTriangle = 6;  // its corners have vertices of their own

std::uint32_t wordAt(ByteSpan bytes, std::size_t at) {
    std::uint32_t word = 0;
    for (std::size_t i = 0; i < 4; ++i) word |= std::uint32_t{bytes[at + i]} << (8 * i);
    return word;
}

std::uint64_t binarySize(ByteSpan bytes) { return dataStart + std::uint64_t{wordAt(bytes, headerSize)} * triangleSize; }

// Compares a word whatever its case, in which writers differ.
bool is(std::string_view word, std::string_view lowerCase) {
    return std::ranges::equal(word, lowerCase, [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

class TextReader {
public:
    TextReader(std::string_view content, std::uint64_t maxElements) : rest_{content}, maxElements_{maxElements} {}

    PolygonFile read() {
        for (std::string_view word = formats::takeWord(rest_); !word.empty(); word = formats::takeWord(rest_)) {
            if (!is(word, "solid")) base::refuse("expected solid or the end of the file, found " + base::quote(word));
            skipLine();
            readSolid();
        }
        return std::move(file_);
    }

private:
    void readSolid() {
        try {
            for (;; ++facet_) {
                const std::string_view word = formats::takeWord(rest_);
                if (is(word, "endsolid")) return skipLine();
                if (file_.faceCount > 0 && (word.empty() || is(word, "solid"))) return readOpenEnd(word);
                readFacet(word);
            }
        } catch (const Error& error) {
            throw Error{error.kind(), base::label("facet", facet_) + ": " + error.what()};
        }
    }

    // Reads what stands in place of endsolid: the end of the file, or the solid that is next, if the word is not empty.
    void readOpenEnd(std::string_view word) {
        if (!word.empty()) rest_ = {word.data(), static_cast<std::size_t>(rest_.data() + rest_.size() - word.data())};
        const std::string_view warning = word.empty()
                                             ? "expected endsolid, found the end of the file: it may be truncated"
                                             : "expected endsolid, found solid: what follows is read as the next solid";
        if (std::ranges::find(file_.warnings, warning) == file_.warnings.end()) file_.warnings.emplace_back(warning);
    }

    void readFacet(std::string_view first) {
        if (first.empty()) refuseEnd();
        if (!is(first, "facet")) base::refuse("expected facet or endsolid, found " + base::quote(first));
        expect("normal");
        for (int i = 0; i < 3; ++i) static_cast<void>(nextWord());
        expect("outer");
        expect("loop");
        for (int corner = 0; corner < 3; ++corner) {
            expect("vertex");
            const double x = nextNumber();
            const double y = nextNumber();
            const double z = nextNumber();
            file_.corners.push_back(static_cast<std::uint32_t>(file_.finePositions.size()));
            file_.finePositions.emplace_back(x, y, z);
        }
        expect("endloop");
        expect("endfacet");
        file_.endFace(3);
        expectWithin(elementsPerTriangle * file_.faceCount, maxElements_);
    }

    void expect(std::string_view word) {
        if (const std::string_view found = nextWord(); !is(found, word))
            base::refuse(fmt::format("expected {}, found {}", word, base::quote(found)));
    }

    double nextNumber() {
        const std::string_view word = nextWord();
        const std::optional<double> number = formats::toNumber<double>(word);
        if (!number || !(std::abs(*number) <= double{std::numeric_limits<float>::max()}))
            base::refuse("expected a finite number, found " + base::quote(word));
        return *number;
    }

    std::string_view nextWord() {
        const std::string_view word = formats::takeWord(rest_);
        if (word.empty()) refuseEnd();
        return word;
    }

    [[noreturn]] static void refuseEnd() {
        base::refuse("expected endsolid, found the end of the file: it is truncated");
    }

    void skipLine() { rest_.remove_prefix(std::min(rest_.find_first_of("\r\n"), rest_.size())); }

    std::string_view rest_;
    std::uint64_t maxElements_;
    std::size_t facet_ = 0;
    PolygonFile file_;
};

// How many triangles are read: as many as the header says, or all there are.
// @param wholeSize  bytes of the file that starts so
std::uint64_t triangleCount(ByteSpan start, std::uint64_t wholeSize, std::vector<std::string>& warnings) {
    const std::uint64_t size = binarySize(start);
    const std::uint64_t said = wordAt(start, headerSize);
    const std::uint64_t found = (wholeSize - dataStart) / triangleSize;
    if (said != 0 && size <= wholeSize) return said;
    if (found == 0 || (wholeSize - dataStart) % triangleSize != 0) {
        if (formats::isUtf16(base::textOf(start))) base::refuse("expected STL, found UTF-16 text: save it as UTF-8");
        base::refuse(
            fmt::format("expected {} bytes for the {} triangles that the header says, found {}: the file is "
                        "truncated or no STL",
                        size, said, wholeSize));
    }
    warnings.push_back(fmt::format("expected {} triangles, as the header says, found {}: all are read", said, found));
    return found;
}

// Whether a file of this size that starts so holds no text.
bool isBinary(ByteSpan start, std::uint64_t wholeSize) {
    const bool exact = start.size() > dataStart && binarySize(start) == wholeSize;
    return exact || base::textOf(start).find('\0') != std::string_view::npos;
}

PolygonFile readBinary(ByteSpan bytes, std::uint64_t maxElements) {
    PolygonFile file;
    const std::uint64_t count = triangleCount(bytes, bytes.size(), file.warnings);
    expectWithin(elementsPerTriangle * count, maxElements);
    file.positions.reserve(3 * count);
    file.corners.reserve(3 * count);
    for (std::uint64_t t = 0; t < count; ++t) {
        std::size_t at = dataStart + t * triangleSize + normalSize;
        const auto next = [&] {
            at += 4;
            return std::bit_cast<float>(wordAt(bytes, at - 4));
        };
        for (int corner = 0; corner < 3; ++corner) {
            const float x = next();
            const float y = next();
            const float z = next();
            file.corners.push_back(static_cast<std::uint32_t>(file.positions.size()));
            file.positions.emplace_back(x, y, z);
        }
        file.endFace(3);
    }
    return file;
}

}  // namespace

PolygonFile readStl(ByteSpan bytes, std::uint64_t maxElements) {
    if (!isBinary(bytes, bytes.size())) {
        const std::string_view content = formats::withoutByteOrderMark(base::textOf(bytes));
        if (!is(formats::trimmed(content).substr(0, 5), "solid"))
            base::refuse(fmt::format("expected STL, found {}", base::kindOf(content)));
        return TextReader{content, maxElements}.read();
    }
    if (bytes.size() < dataStart)
        base::refuse(fmt::format("expected an STL file of at least {} bytes, found {}", dataStart, bytes.size()));
    if (bytes.size() == dataStart && binarySize(bytes) == dataStart) return {};  // of no triangle
    return readBinary(bytes, maxElements);
}

void expectStlWithin(ByteSpan start, std::uint64_t size, std::uint64_t maxElements) {
    if (start.size() <= dataStart || !isBinary(start, size)) return;
    std::vector<std::string> ignored;
    expectWithin(elementsPerTriangle * triangleCount(start, size, ignored), maxElements);
}

}  // namespace inkedge::polygons
