#include "settings/text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/nearest_name.h"
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

constexpr const char* extentForm =
    "WIDTHxHEIGHT or WIDTH in pixels, as in 1024x768, or in mm, cm or in, as in 90x60mm or 90mm";

constexpr std::string_view letters = "xyz";
constexpr std::array<glm::dvec3, 3> axes{glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}};

// The millimetres that a suffix of two letters stands for; 0 for any other text.
double unitOfLength(std::string_view text) {
    if (text.ends_with("mm")) return 1.0;
    if (text.ends_with("cm")) return 10.0;
    return text.ends_with("in") ? 25.4 : 0.0;
}

double parseMillimetres(std::string_view text) {
    const double unit = unitOfLength(text);
    if (unit == 0.0)
        throw Expected{"WIDTHxHEIGHT in mm, cm or in, as in 210mmx297mm, or A0 to A6, Letter, Legal, Tabloid"};
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
    if (found == names.end()) throw Expected{expectation(names), base::suggestion(text, names)};
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

glm::dvec3 parseDirection(std::string_view text) {
    const bool hasSign = text.starts_with('+') || text.starts_with('-');
    const std::string_view axis = text.substr(hasSign ? 1 : 0);
    const std::size_t letter = axis.size() == 1 ? letters.find(static_cast<char>(axis[0] | 0x20)) : letters.npos;
    if (letter != letters.npos) return (text.starts_with('-') ? -1.0 : 1.0) * axes[letter];
    if (text.find(',') == text.npos) throw Expected{"an axis, as in +Z, or a direction x,y,z"};
    const glm::dvec3 direction = parseVector(text);
    if (direction == glm::dvec3{0.0}) throw Expected{"an axis, as in +Z, or a direction other than 0,0,0"};
    return direction;
}

namespace {

double parsePixels(std::string_view text) {
    std::uint64_t pixels = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), pixels);
    if (end != text.data() + text.size() || error == std::errc::invalid_argument) throw Expected{extentForm};
    if (error != std::errc{} || pixels < pictureSides.min || pixels > pictureSides.max)
        throw Expected{fmt::format("{0}x{0} to {1}x{1} pixels", pictureSides.min, pictureSides.max)};
    return static_cast<double>(pixels);
}

// @param unit  millimetres that a number stands for unless it has a unit of its own
double parseSide(std::string_view text, double unit) {
    const double own = unitOfLength(text);
    if (own > 0.0) text.remove_suffix(2);
    const double length = parseNumber(overZero, text) * (own > 0.0 ? own : unit);
    if (length > longestPage) throw Expected{fmt::format("sides of at most {}mm", longestPage)};
    return length;
}

}  // namespace

// WIDTH or WIDTHxHEIGHT, each in pixels, or in millimetres if a unit stands after both or after the last.
PictureExtent parseExtent(std::string_view text) {
    const auto sides = split(text, 'x');
    if (sides.size() > 2) throw Expected{extentForm};
    const double unit = unitOfLength(sides.back());
    const auto parse = [&](std::string_view side) { return unit > 0.0 ? parseSide(side, unit) : parsePixels(side); };
    return {parse(sides.front()), sides.size() == 2 ? parse(sides.back()) : 0.0, unit > 0.0};
}

PictureLength parseMargin(std::string_view text) {
    constexpr Number margin{.min = 0.0, .max = PictureSettings::maxSide};
    PictureLength length;
    length.millimetres = text.ends_with(millimetreSuffix);
    if (length.millimetres || text.ends_with(pixelSuffix)) text.remove_suffix(2);
    length.value = parseNumber(margin, text);
    return length;
}

double parseScale(std::string_view text) {
    constexpr Number part{.min = 1e-6, .max = 1e6};
    const auto parts = split(text, ':');
    if (parts.size() != 2) throw Expected{"a length on paper and one of the model, as in 1:2"};
    const double scale = parseNumber(part, parts[0]) / parseNumber(part, parts[1]);
    if (scale < part.min || scale > part.max) throw Expected{"1:1000000 to 1000000:1"};
    return scale;
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
LightDirection parseLight(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 2) throw Expected{"an azimuth and an elevation in degrees, as in -35,40"};
    return {parseNumber(lightAzimuth, parts[0]), parseNumber(lightElevation, parts[1])};
}

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

namespace {

constexpr std::string_view hiddenName = "hidden";

DashPattern parseDash(std::string_view text) {
    const auto parts = split(text, ':');
    if (parts.size() != 2) throw Expected{"dash=LENGTH:GAP in pixels, or in mm, as in dash=3mm:1.5mm"};
    const auto parse = [](std::string_view part) {
        const PictureLength length = parseMargin(part);
        if (length.value == 0.0) throw Expected{"dashes and gaps over 0"};
        return length;
    };
    return {parse(parts[0]), parse(parts[1])};
}

// @return  whether it is a field of every pen
template <class Pen>
bool takeField(std::string_view field, Pen& pen) {
    if (field.starts_with("width="))
        pen.width = parseLength(field.substr(6));
    else if (field.starts_with("color="))
        pen.color = parseColor(field.substr(6));
    else
        return false;
    return true;
}

template <class Pen>
std::vector<std::string> fieldsOf(const Pen& pen) {
    std::vector<std::string> fields;
    if (pen.width) fields.push_back("width=" + textOf(*pen.width));
    if (pen.color) fields.push_back("color=" + textOf(*pen.color));
    return fields;
}

}  // namespace

// TYPE:width=W,color=C;TYPE:...
Pens parsePens(std::string_view text) {
    const Expected expected{"TYPE:width=W,color=C;... with one or both of width and color, or hidden:...,dash=L:G"};
    Pens pens;
    for (const std::string_view part : split(text, ';')) {
        const std::size_t colon = part.find(':');
        if (colon == std::string_view::npos) throw expected;
        const std::string_view name = part.substr(0, colon);
        const std::vector<std::string_view> fields = split(part.substr(colon + 1), ',');
        if (name == hiddenName) {
            for (const std::string_view field : fields) {
                if (takeField(field, pens.hidden)) continue;
                if (!field.starts_with("dash=")) throw expected;
                pens.hidden.dash = parseDash(field.substr(5));
            }
            continue;
        }
        PenSettings& pen = pens.types[static_cast<std::size_t>(parseChoice(lineTypeNames, name))];
        for (const std::string_view field : fields)
            if (!takeField(field, pen)) throw expected;
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
// + 0.0 makes a 0 of -0, which nobody types.
std::string textOf(glm::dvec3 v) { return fmt::format("{},{},{}", v.x + 0.0, v.y + 0.0, v.z + 0.0); }
std::string textOf(Size size) { return fmt::format("{}x{}", size.width, size.height); }
std::string textOf(Color color) { return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue); }
std::string textOf(const PageSize& page) { return fmt::format("{}mmx{}mm", page.width, page.height); }

std::string textOf(const PictureLength& length) {
    return fmt::format("{}{}", length.value, length.millimetres ? millimetreSuffix : "");
}

std::string textOf(LightDirection light) {
    return fmt::format("{},{}", textOf(light.azimuth), textOf(light.elevation));
}

std::string textOf(const Isolines& isolines) {
    return isolines.u == isolines.v ? fmt::format("{}", isolines.u) : fmt::format("u:{},v:{}", isolines.u, isolines.v);
}

std::string textOf(const PictureExtent& extent) {
    const std::string_view unit = extent.millimetres ? millimetreSuffix : "";
    if (extent.height == 0.0) return fmt::format("{}{}", extent.width, unit);
    return fmt::format("{}{}x{}{}", extent.width, unit, extent.height, unit);
}

std::string textOfDirection(glm::dvec3 direction) {
    for (std::size_t i = 0; i < axes.size(); ++i) {
        const char letter = static_cast<char>(letters[i] - 0x20);
        if (direction == axes[i]) return fmt::format("+{}", letter);
        if (direction == -axes[i]) return fmt::format("-{}", letter);
    }
    return textOf(direction);
}

std::string textOfScale(double scale) {
    return scale < 1.0 ? fmt::format("1:{:.12g}", 1.0 / scale) : fmt::format("{:.12g}:1", scale);
}

std::string textOf(const Pens& pens) {
    std::vector<std::string> parts;
    const auto add = [&](std::string_view name, const std::vector<std::string>& fields) {
        if (!fields.empty()) parts.push_back(fmt::format("{}:{}", name, fmt::join(fields, ",")));
    };
    for (std::size_t i = 0; i < pens.types.size(); ++i) add(lineTypeNames[i], fieldsOf(pens.types[i]));
    std::vector<std::string> hidden = fieldsOf(pens.hidden);
    if (pens.hidden.dash)
        hidden.push_back(fmt::format("dash={}:{}", textOf(pens.hidden.dash->dash), textOf(pens.hidden.dash->gap)));
    add(hiddenName, hidden);
    return fmt::format("{}", fmt::join(parts, ";"));
}

std::string textOf(const std::vector<FunctionSettings>& functions) {
    std::vector<std::string> parts;
    for (const FunctionSettings& function : functions) parts.push_back(text(function));
    return fmt::format("{}", fmt::join(parts, ";"));
}

}  // namespace inkedge::settings
