#include "sheet/letters.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace inkedge::sheet {
namespace {

constexpr double unitsOfHeight = 10.0;
constexpr double spacing = 2.0;  // between letters
constexpr double wordSpace = 4.0;

// Strokes are points "xy" with blanks between them, and commas between strokes: x from 0 to 8 to the right, y upwards
// from the line, A is 10 and so on; m and n are one and two below the line.
struct Glyph {
    char32_t letter;
    double width;
    std::string_view strokes;
};

constexpr std::array glyphs{
    Glyph{U' ', wordSpace, ""},
    Glyph{U'A', 6, "00 3A 60,13 53"},
    Glyph{U'B', 6, "00 0A 4A 59 56 45 05,45 64 61 40 00"},
    Glyph{U'C', 6, "68 4A 2A 08 02 20 40 62"},
    Glyph{U'D', 6, "00 0A 3A 67 63 30 00"},
    Glyph{U'E', 5, "50 00 0A 5A,05 45"},
    Glyph{U'F', 5, "00 0A 5A,05 45"},
    Glyph{U'G', 6, "68 4A 2A 08 02 20 40 62 65 35"},
    Glyph{U'H', 6, "00 0A,60 6A,05 65"},
    Glyph{U'I', 0, "00 0A"},
    Glyph{U'J', 4, "4A 42 30 10 02"},
    Glyph{U'K', 6, "00 0A,6A 04,26 60"},
    Glyph{U'L', 5, "0A 00 50"},
    Glyph{U'M', 6, "00 0A 34 6A 60"},
    Glyph{U'N', 6, "00 0A 60 6A"},
    Glyph{U'O', 6, "20 40 62 68 4A 2A 08 02 20"},
    Glyph{U'P', 6, "00 0A 4A 69 66 45 05"},
    Glyph{U'Q', 6, "20 40 62 68 4A 2A 08 02 20,43 6m"},
    Glyph{U'R', 6, "00 0A 4A 69 66 45 05,35 60"},
    Glyph{U'S', 6, "02 20 40 62 64 45 25 06 08 2A 4A 68"},
    Glyph{U'T', 6, "30 3A,0A 6A"},
    Glyph{U'U', 6, "0A 02 20 40 62 6A"},
    Glyph{U'V', 6, "0A 30 6A"},
    Glyph{U'W', 8, "0A 20 48 60 8A"},
    Glyph{U'X', 6, "00 6A,0A 60"},
    Glyph{U'Y', 6, "0A 35 6A,35 30"},
    Glyph{U'Z', 6, "0A 6A 00 60"},
    Glyph{U'0', 5, "20 30 52 58 3A 2A 08 02 20"},
    Glyph{U'1', 2, "07 2A 20"},
    Glyph{U'2', 5, "08 2A 3A 58 56 00 50"},
    Glyph{U'3', 5, "08 2A 3A 58 57 35 25,35 53 52 30 20 02"},
    Glyph{U'4', 5, "40 4A 03 53"},
    Glyph{U'5', 5, "5A 0A 05 26 36 54 52 30 20 02"},
    Glyph{U'6', 5, "58 3A 2A 08 02 20 30 52 54 36 26 04"},
    Glyph{U'7', 5, "0A 5A 20"},
    Glyph{U'8', 5, "25 07 08 2A 3A 58 57 35 25 03 02 20 30 52 53 35"},
    Glyph{U'9', 5, "02 20 30 52 58 3A 2A 08 06 24 34 56"},
    Glyph{U'.', 1, "00 10 11 01 00"},
    Glyph{U',', 1, "11 10 0n"},
    Glyph{U':', 1, "01 11 12 02 01,06 16 17 07 06"},
    Glyph{U';', 1, "12 11 0m,06 16 17 07 06"},
    Glyph{U'-', 4, "05 45"},
    Glyph{U'_', 6, "0m 6m"},
    Glyph{U'+', 6, "05 65,32 38"},
    Glyph{U'=', 5, "03 53,07 57"},
    Glyph{U'/', 4, "00 4A"},
    Glyph{U'\\', 4, "0A 40"},
    Glyph{U'|', 0, "0m 0B"},
    Glyph{U'(', 2, "2A 07 03 20"},
    Glyph{U')', 2, "0A 27 23 00"},
    Glyph{U'[', 2, "2A 0A 00 20"},
    Glyph{U']', 2, "0A 2A 20 00"},
    Glyph{U'<', 5, "58 05 52"},
    Glyph{U'>', 5, "08 55 02"},
    Glyph{U'%', 6, "00 6A,07 0A 2A 27 07,40 43 63 60 40"},
    Glyph{U'&', 6, "60 17 19 2A 3A 49 48 03 02 20 30 64"},
    Glyph{U'\'', 0, "0A 08"},
    Glyph{U'"', 2, "0A 08,2A 28"},
    Glyph{U'#', 6, "10 2A,40 5A,03 63,07 67"},
    Glyph{U'*', 6, "32 38,03 67,07 63"},
    Glyph{U'!', 1, "0A 03,00 10 11 01 00"},
    Glyph{U'?', 6, "08 2A 4A 68 66 34 33,30 31"},
    Glyph{U'@', 6, "64 43 34 36 47 57 54 64 68 4A 2A 08 02 20 50"},
    Glyph{U'\u00B0', 3, "17 27 38 39 2A 1A 09 08 17"},           // degree
    Glyph{U'\u00B1', 6, "06 66,33 39,00 60"},                    // plus or minus
    Glyph{U'\u00B5', 6, "0n 07,02 20 40 62,67 60"},              // micro
    Glyph{U'\u00D7', 5, "02 57,07 52"},                          // times
    Glyph{U'\u00D8', 6, "20 40 62 68 4A 2A 08 02 20,00 6A"},     // O with a stroke
    Glyph{U'\u2300', 6, "20 40 62 68 4A 2A 08 02 20,00 6A"},     // diameter
    Glyph{U'\u00DF', 6, "00 08 1A 3A 59 56 35,35 64 61 40 30"},  // sharp s
    Glyph{U'\u00C6', 8, "00 4A,13 43,80 40 4A 8A,45 75"},        // AE
    Glyph{U'\u0152', 8, "80 20 02 08 2A 8A,40 4A,45 75"},        // OE
    Glyph{U'\u2013', 6, "05 65"},                                // dashes
    Glyph{U'\u2014', 8, "05 85"},
};

// Marks over a letter 6 wide, or below it.
struct Mark {
    char32_t letter;
    char base;
    std::string_view strokes;
};
constexpr std::string_view grave = "2D 3B";
constexpr std::string_view acute = "3B 4D";
constexpr std::string_view circumflex = "1B 3D 5B";
constexpr std::string_view tilde = "1B 2C 4B 5C";
constexpr std::string_view dots = "1B 1C,5B 5C";
constexpr std::string_view ring = "3A 4B 4C 3D 2C 2B 3A";
constexpr std::string_view cedilla = "30 4m 3n 2n";
constexpr std::array marks{
    Mark{U'\u00C0', 'A', grave},      Mark{U'\u00C1', 'A', acute},      Mark{U'\u00C2', 'A', circumflex},
    Mark{U'\u00C3', 'A', tilde},      Mark{U'\u00C4', 'A', dots},       Mark{U'\u00C5', 'A', ring},
    Mark{U'\u00C7', 'C', cedilla},    Mark{U'\u00C8', 'E', grave},      Mark{U'\u00C9', 'E', acute},
    Mark{U'\u00CA', 'E', circumflex}, Mark{U'\u00CB', 'E', dots},       Mark{U'\u00D1', 'N', tilde},
    Mark{U'\u00D2', 'O', grave},      Mark{U'\u00D3', 'O', acute},      Mark{U'\u00D4', 'O', circumflex},
    Mark{U'\u00D5', 'O', tilde},      Mark{U'\u00D6', 'O', dots},       Mark{U'\u00D9', 'U', grave},
    Mark{U'\u00DA', 'U', acute},      Mark{U'\u00DB', 'U', circumflex}, Mark{U'\u00DC', 'U', dots},
};

constexpr Glyph unknownGlyph{0, 5, "00 50 5A 0A 00"};
constexpr char32_t replacement = U'\uFFFD';

// The characters of UTF-8; bytes that are none are the replacement character.
std::u32string decoded(std::string_view text) {
    std::u32string characters;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i++]);
        const int more = first < 0x80U ? 0 : first >= 0xF0U ? 3 : first >= 0xE0U ? 2 : 1;
        char32_t character = first < 0x80U ? first : first & (0x3FU >> static_cast<unsigned>(more));
        bool whole = first < 0x80U || first >= 0xC0U;
        for (int k = 0; k < more && whole; ++k) {
            whole = i < text.size() && (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
            if (whole) character = character << 6U | (static_cast<unsigned char>(text[i++]) & 0x3FU);
        }
        characters += whole ? character : replacement;
    }
    return characters;
}

std::string encoded(char32_t c) {
    const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
    if (c < 0x80U) return {byte(c)};
    if (c < 0x800U) return {byte(0xC0U | c >> 6U), byte(0x80U | (c & 0x3FU))};
    if (c < 0x10000U) return {byte(0xE0U | c >> 12U), byte(0x80U | (c >> 6U & 0x3FU)), byte(0x80U | (c & 0x3FU))};
    return {byte(0xF0U | c >> 18U), byte(0x80U | (c >> 12U & 0x3FU)), byte(0x80U | (c >> 6U & 0x3FU)),
            byte(0x80U | (c & 0x3FU))};
}

// Of ASCII and Latin-1.
char32_t capital(char32_t c) {
    const bool latin = c >= U'\u00E0' && c <= U'\u00FE' && c != U'\u00F7';
    return (c >= U'a' && c <= U'z') || latin ? c - 0x20U : c == U'\u0153' ? U'\u0152' : c;
}

struct Found {
    Glyph glyph;
    std::string_view mark;
    bool known = true;
};

Found find(char32_t character) {
    const char32_t letter = capital(character);
    const auto* const glyph = std::ranges::find(glyphs, letter, &Glyph::letter);
    if (glyph != glyphs.end()) return {*glyph, {}};
    const auto* const mark = std::ranges::find(marks, letter, &Mark::letter);
    if (mark == marks.end()) return {unknownGlyph, {}, false};
    return {find(static_cast<char32_t>(mark->base)).glyph, mark->strokes};
}

glm::dvec2 pointOf(std::string_view digits) {
    const auto value = [](char c) {
        if (c == 'm' || c == 'n') return c == 'm' ? -1.0 : -2.0;
        return c <= '9' ? static_cast<double>(c - '0') : static_cast<double>(c - 'A' + 10);
    };
    return {value(digits[0]), value(digits[1])};
}

void writeStrokes(io::Path& path, std::string_view strokes, glm::dvec2 at, double unit) {
    bool begins = true;
    for (; strokes.size() >= 2; strokes.remove_prefix(std::min<std::size_t>(3, strokes.size()))) {
        const glm::dvec2 point = pointOf(strokes);
        const glm::dvec2 onPage = at + unit * glm::dvec2{point.x, -point.y};
        if (begins) {
            path.moveTo(onPage);
        } else {
            path.lineTo(onPage);
        }
        begins = strokes.size() > 2 && strokes[2] == ',';
    }
}

}  // namespace

double widthOf(std::string_view text, double height) {
    double width = 0.0;
    for (const char32_t c : decoded(text)) width += find(c).glyph.width + spacing;
    return std::max(width - spacing, 0.0) * height / unitsOfHeight;
}

void write(io::Path& path, std::string_view text, glm::dvec2 at, double height) {
    const double unit = height / unitsOfHeight;
    for (const char32_t c : decoded(text)) {
        const Found found = find(c);
        writeStrokes(path, found.glyph.strokes, at, unit);
        writeStrokes(path, found.mark, at, unit);
        at.x += unit * (found.glyph.width + spacing);
    }
}

std::string unknownIn(std::string_view text) {
    std::u32string unknown;
    for (const char32_t c : decoded(text))
        if (!find(c).known && unknown.find(c) == std::u32string::npos) unknown += c;
    std::string result;
    for (const char32_t c : unknown) result += encoded(c);
    return result;
}

}  // namespace inkedge::sheet
