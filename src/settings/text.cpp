#include "settings/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settings/constraints.h"
#include "settings/names.h"

namespace inkedge::settings {
namespace {

constexpr Number coordinate{.min = -1e38, .max = 1e38};  // as floats hold
constexpr Number overZero{.min = 0.0, .open = true};
constexpr Number millimetres{.min = 0.001, .max = 1000.0};

// The number that k, M or G stands for; 0 for any other text, which is no suffix.
std::uint64_t unitOf(std::string_view suffix) {
    if (suffix.empty()) return 1;
    if (suffix == "k") return 1'000;
    if (suffix == "M") return 1'000'000;
    return suffix == "G" ? 1'000'000'000 : 0;
}

struct NamedColor {
    std::string_view name;
    Color color;
};
constexpr std::array namedColors{
    NamedColor{"black", {0, 0, 0}}, NamedColor{"white", {255, 255, 255}}, NamedColor{"grey", {128, 128, 128}},
    NamedColor{"red", {255, 0, 0}}, NamedColor{"green", {0, 128, 0}},     NamedColor{"blue", {0, 0, 255}},
};

constexpr std::string_view millimetreSuffix = "mm";
constexpr std::string_view pixelSuffix = "px";

struct NamedPage {
    std::string_view name;
    PageSize size;
};
constexpr std::array namedPages{
    NamedPage{"A0", {841, 1189}},         NamedPage{"A1", {594, 841}},         NamedPage{"A2", {420, 594}},
    NamedPage{"A3", {297, 420}},          NamedPage{"A4", {210, 297}},         NamedPage{"A5", {148, 210}},
    NamedPage{"A6", {105, 148}},          NamedPage{"Letter", {215.9, 279.4}}, NamedPage{"Legal", {215.9, 355.6}},
    NamedPage{"Tabloid", {279.4, 431.8}},
};
constexpr std::string_view landscapeSuffix = "-landscape";
constexpr double longestPage = 100'000.0;  // millimetres

double parseMillimetres(std::string_view text) {
    const Expected expected{"WIDTHxHEIGHT in mm, cm or in, as in 210mmx297mm, or A0 to A6, Letter, Legal, Tabloid"};
    double unit = 0.0;
    if (text.ends_with("mm")) unit = 1.0;
    if (text.ends_with("cm")) unit = 10.0;
    if (text.ends_with("in")) unit = 25.4;
    if (unit == 0.0) throw expected;
    const double value = parseNumber(overZero, text.substr(0, text.size() - 2)) * unit;
    if (value < 1.0 || value > longestPage) throw Expected{fmt::format("sides from 1mm to {}mm", longestPage)};
    return value;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

double parseNumber(const Number& number, std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) throw Expected{"a number"};
    const bool inside =
        number.open ? value > number.min && value < number.max : value >= number.min && value <= number.max;
    if (!inside && !(number.zeroToo && value == 0.0)) throw Expected{expectation(number)};
    return value;
}

std::uint64_t parseCount(const Count& count, std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::string_view suffix = text.substr(static_cast<std::size_t>(end - text.data()));
    const std::uint64_t unit = count.suffixes || suffix.empty() ? unitOf(suffix) : 0;
    if (error != std::errc{} || unit == 0 || value > count.max / unit || value * unit < count.min)
        throw Expected{expectation(count)};
    value *= unit;
    const auto isValue = [&](int choice) { return static_cast<std::uint64_t>(choice) == value; };
    if (!count.choices.empty() && std::ranges::none_of(count.choices, isValue)) throw Expected{expectation(count)};
    return value;
}

int parseChoice(std::span<const std::string_view> names, std::string_view text) {
    const auto found = std::ranges::find(names, text);
    if (found == names.end()) throw Expected{expectation(names)};
    return static_cast<int>(found - names.begin());
}

std::string nameOf(std::span<const std::string_view> names, int value) {
    const bool known = value >= 0 && static_cast<std::size_t>(value) < names.size();
    return known ? std::string{names[static_cast<std::size_t>(value)]} : fmt::format("{}", value);
}

glm::dvec3 parseVector(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 3) throw Expected{"three numbers x,y,z"};
    return {parseNumber(coordinate, parts[0]), parseNumber(coordinate, parts[1]), parseNumber(coordinate, parts[2])};
}

Size parseSize(std::string_view text) {
    const auto parts = split(text, 'x');
    if (parts.size() != 2) throw Expected{"WIDTHxHEIGHT in pixels, for example 1024x768"};
    constexpr Count whole{};
    const std::uint64_t width = parseCount(whole, parts[0]);
    const std::uint64_t height = parseCount(whole, parts[1]);
    if (std::min(width, height) < pictureSides.min || std::max(width, height) > pictureSides.max)
        throw Expected{fmt::format("{0}x{0} to {1}x{1} pixels", pictureSides.min, pictureSides.max)};
    return {static_cast<int>(width), static_cast<int>(height)};
}

Color parseColor(std::string_view text) {
    const auto* named = std::ranges::find(namedColors, text, &NamedColor::name);
    if (named != namedColors.end()) return named->color;
    const Expected expected{"a colour #RGB, #RRGGBB, black, white, grey, red, green or blue"};
    if ((text.size() != 4 && text.size() != 7) || text[0] != '#') throw expected;
    const std::size_t digits = text.size() == 4 ? 1 : 2;
    std::array<std::uint8_t, 3> channels{};
    for (std::size_t i = 0; i < 3; ++i) {
        const char* begin = text.data() + 1 + i * digits;
        unsigned value = 0;
        const auto [end, error] = std::from_chars(begin, begin + digits, value, 16);
        if (error != std::errc{} || end != begin + digits) throw expected;
        channels[i] = static_cast<std::uint8_t>(digits == 1 ? value * 17 : value);
    }
    return {channels[0], channels[1], channels[2]};
}

PictureLength parseLength(std::string_view text) {
    PictureLength length;
    length.millimetres = text.ends_with(millimetreSuffix);
    if (length.millimetres || text.ends_with(pixelSuffix)) text.remove_suffix(2);
    length.value = length.millimetres ? parseNumber(millimetres, text) : parseNumber(penWidth, text);
    return length;
}

PageSize parsePage(std::string_view text) {
    const bool landscape = text.ends_with(landscapeSuffix);
    const std::string_view name = landscape ? text.substr(0, text.size() - landscapeSuffix.size()) : text;
    const auto* named = std::ranges::find(namedPages, name, &NamedPage::name);
    if (named != namedPages.end()) {
        return landscape ? PageSize{named->size.height, named->size.width} : named->size;
    }
    const std::size_t between = text.find('x');
    if (between == std::string_view::npos) parseMillimetres({});  // throws what is expected
    return {parseMillimetres(text.substr(0, between)), parseMillimetres(text.substr(between + 1))};
}

// N, or u:N,v:M with one or both.
Isolines parseIsolines(std::string_view text) {
    const auto steps = [](std::string_view number) { return static_cast<int>(parseCount(isolineSteps, number)); };
    if (text.find(':') == std::string_view::npos) {
        const int both = steps(text);
        return {both, both};
    }
    Isolines isolines;
    for (const std::string_view part : split(text, ',')) {
        if (part.starts_with("u:"))
            isolines.u = steps(part.substr(2));
        else if (part.starts_with("v:"))
            isolines.v = steps(part.substr(2));
        else
            throw Expected{"a whole number, or u:N,v:N with one or both"};
    }
    return isolines;
}

// TYPE:width=W,color=C;TYPE:...
std::array<PenSettings, lineTypeCount> parsePens(std::string_view text) {
    std::array<PenSettings, lineTypeCount> pens;
    for (const std::string_view part : split(text, ';')) {
        const std::size_t colon = part.find(':');
        const Expected expected{"TYPE:width=W,color=C;... with one or both of width and color"};
        if (colon == std::string_view::npos) throw expected;
        PenSettings& pen = pens[static_cast<std::size_t>(parseChoice(lineTypeNames, part.substr(0, colon)))];
        for (const std::string_view field : split(part.substr(colon + 1), ',')) {
            if (field.starts_with("width=")) {
                pen.width = parseLength(field.substr(6));
            } else if (field.starts_with("color=")) {
                pen.color = parseColor(field.substr(6));
            } else {
                throw expected;
            }
        }
    }
    return pens;
}

std::vector<FunctionSettings> parseFunctions(std::string_view text) {
    std::vector<FunctionSettings> functions;
    for (const std::string_view part : split(text, ';'))
        functions.push_back(surfaceFunction(part.substr(std::min(part.find_first_not_of(' '), part.size()))));
    return functions;
}

void checkFunctions(const std::vector<FunctionSettings>& functions) {
    for (FunctionSettings function : functions) {
        if (!function.file.empty()) function.file = "file";  // a comma in its name would part it
        (void)surfaceFunction(text(function));
    }
}

std::string textOf(double value) { return fmt::format("{}", value); }
std::string textOf(float value) { return fmt::format("{}", value); }
std::string textOf(int value) { return fmt::format("{}", value); }
std::string textOf(std::uint64_t value) { return fmt::format("{}", value); }
std::string textOf(const std::string& value) { return value; }
std::string textOf(const std::filesystem::path& file) { return file.string(); }
std::string textOf(glm::dvec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }
std::string textOf(Size size) { return fmt::format("{}x{}", size.width, size.height); }
std::string textOf(Color color) { return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue); }
std::string textOf(const PageSize& page) { return fmt::format("{}mmx{}mm", page.width, page.height); }

std::string textOf(const PictureLength& length) {
    return fmt::format("{}{}", length.value, length.millimetres ? millimetreSuffix : "");
}

std::string textOf(const Isolines& isolines) {
    return isolines.u == isolines.v ? fmt::format("{}", isolines.u) : fmt::format("u:{},v:{}", isolines.u, isolines.v);
}

std::string textOf(const std::array<PenSettings, lineTypeCount>& pens) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < pens.size(); ++i) {
        std::vector<std::string> fields;
        if (pens[i].width) fields.push_back("width=" + textOf(*pens[i].width));
        if (pens[i].color) fields.push_back("color=" + textOf(*pens[i].color));
        if (!fields.empty()) parts.push_back(fmt::format("{}:{}", lineTypeNames[i], fmt::join(fields, ",")));
    }
    return fmt::format("{}", fmt::join(parts, ";"));
}

std::string textOf(const std::vector<FunctionSettings>& functions) {
    std::vector<std::string> parts;
    for (const FunctionSettings& function : functions) parts.push_back(text(function));
    return fmt::format("{}", fmt::join(parts, ";"));
}

}  // namespace inkedge::settings
