#include <inkedge/settings.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>

namespace inkedge {
namespace {

// What a setting's text should have been; set() adds the name and the text itself.
struct Expected {
    std::string what;
};

// Why a setting's text cannot be taken, in full; set() adds the name.
struct Refused {
    std::string why;
};

double parseNumber(std::string_view text) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) throw Expected{"a number"};
    return value;
}

double parseNumber(std::string_view text, double low, double high) {
    const double value = parseNumber(text);
    if (value < low || value > high) throw Expected{fmt::format("a number from {} to {}", low, high)};
    return value;
}

double parsePositive(std::string_view text) {
    const double value = parseNumber(text);
    if (value <= 0.0) throw Expected{"a number over 0"};
    return value;
}

int parseCount(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < 0) throw Expected{"a whole number from 0"};
    return value;
}

int parseLevels(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < 0 || value > 6)
        throw Expected{"a whole number from 0 to 6"};
    return value;
}

int parseCount(std::string_view text, int low, int high) {
    const int value = parseCount(text);
    if (value < low || value > high) throw Expected{fmt::format("a whole number from {} to {}", low, high)};
    return value;
}

// A whole number; k, M and G stand for thousands, millions and thousands of millions.
std::uint64_t parseAmount(std::string_view text, std::uint64_t most = std::uint64_t{1} << 40U) {
    const Expected expected{fmt::format("a whole number from 1 to {}, k, M or G after it if wished", most)};
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::string_view suffix = text.substr(static_cast<std::size_t>(end - text.data()));
    std::uint64_t unit = suffix.empty() ? 1 : 0;
    if (suffix == "k") unit = 1'000;
    if (suffix == "M") unit = 1'000'000;
    if (suffix == "G") unit = 1'000'000'000;
    if (error != std::errc{} || unit == 0 || value == 0 || value > most / unit) throw expected;
    return value * unit;
}

std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    for (std::size_t begin = 0;;) {
        const std::size_t end = text.find(separator, begin);
        parts.push_back(text.substr(begin, end - begin));
        if (end == std::string_view::npos) return parts;
        begin = end + 1;
    }
}

glm::dvec3 parseVector(std::string_view text) {
    const auto parts = split(text, ',');
    if (parts.size() != 3) throw Expected{"three numbers x,y,z"};
    return {parseNumber(parts[0]), parseNumber(parts[1]), parseNumber(parts[2])};
}

Size parseSize(std::string_view text) {
    const auto parts = split(text, 'x');
    if (parts.size() != 2) throw Expected{"WIDTHxHEIGHT in pixels, for example 1024x768"};
    const Size size{parseCount(parts[0]), parseCount(parts[1])};
    constexpr int most = PictureSettings::mostSide;
    if (std::min(size.width, size.height) < 1 || std::max(size.width, size.height) > most) {
        throw Expected{fmt::format("1x1 to {0}x{0} pixels", most)};
    }
    return size;
}

struct NamedColor {
    std::string_view name;
    Color color;
};
constexpr std::array namedColors{
    NamedColor{"black", {0, 0, 0}}, NamedColor{"white", {255, 255, 255}}, NamedColor{"grey", {128, 128, 128}},
    NamedColor{"red", {255, 0, 0}}, NamedColor{"green", {0, 128, 0}},     NamedColor{"blue", {0, 0, 255}},
};

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

std::string text(Color color) { return fmt::format("#{:02x}{:02x}{:02x}", color.red, color.green, color.blue); }
std::string text(glm::dvec3 v) { return fmt::format("{},{},{}", v.x, v.y, v.z); }
std::string text(double value) { return fmt::format("{}", value); }
std::string text(float value) { return fmt::format("{}", value); }
std::string text(std::uint64_t value) { return fmt::format("{}", value); }
std::string text(const PageSize& page) { return fmt::format("{}mmx{}mm", page.width, page.height); }
std::string text(int value) { return fmt::format("{}", value); }

template <class T>
std::string text(const std::optional<T>& value) {
    return value ? text(*value) : std::string{};
}

template <class T>
struct Choice {
    std::string_view name;
    T value;
};
template <class T>
Choice(std::string_view, T) -> Choice<T>;
constexpr std::array normalsChoices{Choice{"auto", Normals::Auto}, Choice{"authored", Normals::Authored},
                                    Choice{"flat", Normals::Flat}};
constexpr std::array transparentChoices{Choice{"solid", Transparent::Solid}, Choice{"ignore", Transparent::Ignore}};
constexpr std::array alphaMaskChoices{Choice{"cut", AlphaMask::Cut}, Choice{"ignore", AlphaMask::Ignore}};
constexpr std::array backFacesChoices{Choice{"draw", BackFaces::Draw}, Choice{"material", BackFaces::Material}};
constexpr std::array detectorChoices{Choice{"planes", Detector::Planes}, Choice{"classic", Detector::Classic},
                                     Choice{"saito-takahashi", Detector::SaitoTakahashi},
                                     Choice{"none", Detector::None}};
constexpr std::array kernelChoices{Choice{"sobel", Kernel::Sobel}, Choice{"farid", Kernel::Farid}};
constexpr std::array depthMapChoices{Choice{"linear", DepthMap::Linear}, Choice{"window", DepthMap::Window}};
constexpr std::array lightsChoices{Choice{"single", NormalLights::Single}, Choice{"two-pass", NormalLights::TwoPass}};
constexpr std::array lightSpaceChoices{Choice{"camera", LightSpace::Camera}, Choice{"world", LightSpace::World}};
constexpr std::array backendChoices{Choice{"auto", Backend::Auto}, Choice{"egl", Backend::Egl},
                                    Choice{"osmesa", Backend::Osmesa}};
constexpr std::array<Choice<Map>, mapCount> mapChoices{Choice{"depth", Map::Depth},
                                                       Choice{"normal", Map::Normal},
                                                       Choice{"depth-edges", Map::DepthEdges},
                                                       Choice{"normal-edges", Map::NormalEdges},
                                                       Choice{"edges", Map::Edges},
                                                       Choice{"types", Map::Types},
                                                       Choice{"ids", Map::Ids}};
constexpr std::array<Choice<LineType>, lineTypeCount> lineTypeChoices{Choice{"outline", LineType::Outline},
                                                                      Choice{"occlusion", LineType::Occlusion},
                                                                      Choice{"boundary", LineType::Boundary},
                                                                      Choice{"crease", LineType::Crease},
                                                                      Choice{"intersection", LineType::Intersection},
                                                                      Choice{"object", LineType::Object},
                                                                      Choice{"isoparametric", LineType::Isoparametric},
                                                                      Choice{"marked", LineType::Marked}};
constexpr std::array linesFromChoices{Choice{"auto", LinesFrom::Auto}, Choice{"image", LinesFrom::Image},
                                      Choice{"object", LinesFrom::Object}};
constexpr std::array contourChoices{Choice{"auto", Contour::Auto}, Choice{"mesh", Contour::Mesh},
                                    Choice{"smooth", Contour::Smooth}};
constexpr std::array contourFinderChoices{Choice{"every", ContourFinder::Every},
                                          Choice{"random", ContourFinder::Random},
                                          Choice{"gauss", ContourFinder::Gauss}};
constexpr std::array visibilityChoices{Choice{"exact", Visibility::Exact}, Choice{"fast", Visibility::Fast}};
constexpr std::array hiddenChoices{Choice{"none", HiddenLines::None}, Choice{"dashed", HiddenLines::Dashed},
                                   Choice{"solid", HiddenLines::Solid}};
constexpr std::array strokeWidthChoices{Choice{"constant", StrokeWidth::Constant}, Choice{"depth", StrokeWidth::Depth},
                                        Choice{"curvature", StrokeWidth::Curvature}};
constexpr std::array styleChoices{Choice{"ink", Style::Ink}, Choice{"hatch", Style::Hatch}, Choice{"sumi", Style::Sumi},
                                  Choice{"pencil", Style::Pencil}};

template <class T, std::size_t n>
T parseChoice(const std::array<Choice<T>, n>& choices, std::string_view text) {
    for (const Choice<T>& choice : choices) {
        if (choice.name == text) return choice.value;
    }
    std::vector<std::string_view> names;
    for (const Choice<T>& choice : choices) names.push_back(choice.name);
    throw Expected{n == 1 ? std::string{names[0]} : fmt::format("one of {}", fmt::join(names, ", "))};
}

template <class T, std::size_t n>
std::string choiceName(const std::array<Choice<T>, n>& choices, T value) {
    return std::string{std::ranges::find(choices, value, &Choice<T>::value)->name};
}

std::vector<Map> parseMaps(std::string_view text) {
    std::vector<Map> maps;
    for (const std::string_view part : split(text, ',')) {
        const Map map = parseChoice(mapChoices, part);
        if (std::ranges::find(maps, map) == maps.end()) maps.push_back(map);
    }
    return maps;
}

std::string text(const std::vector<Map>& maps) {
    std::vector<std::string_view> names;
    for (const Map map : maps) names.push_back(name(map));
    return fmt::format("{}", fmt::join(names, ","));
}

constexpr std::string_view millimetreSuffix = "mm";
constexpr std::string_view pixelSuffix = "px";

PictureLength parseLength(std::string_view text) {
    PictureLength length;
    length.millimetres = text.ends_with(millimetreSuffix);
    if (length.millimetres || text.ends_with(pixelSuffix)) text.remove_suffix(2);
    length.value = length.millimetres ? parsePositive(text) : parseNumber(text, 0.5, 32.0);
    return length;
}

std::string text(const PictureLength& length) {
    return fmt::format("{}{}", length.value, length.millimetres ? millimetreSuffix : "");
}

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
    const double value = parsePositive(text.substr(0, text.size() - 2)) * unit;
    if (value < 1.0 || value > longestPage) throw Expected{fmt::format("sides from 1mm to {}mm", longestPage)};
    return value;
}

PageSize parsePage(std::string_view text) {
    const bool landscape = text.ends_with(landscapeSuffix);
    const std::string_view name = landscape ? text.substr(0, text.size() - landscapeSuffix.size()) : text;
    const auto* named = std::ranges::find(namedPages, name, &NamedPage::name);
    if (named != namedPages.end()) {
        return landscape ? PageSize{named->size.height, named->size.width} : named->size;
    }
    const std::size_t between = text.find('x');
    if (between == std::string_view::npos) parseMillimetres({});  // says what is expected
    return {parseMillimetres(text.substr(0, between)), parseMillimetres(text.substr(between + 1))};
}

LineTypes parseLineTypes(std::string_view text) {
    LineTypes types;
    if (text == "none") return types;
    if (text == "all") return allLineTypes;
    for (const std::string_view part : split(text, ',')) types |= parseChoice(lineTypeChoices, part);
    return types;
}

std::string lineTypesText(LineTypes types) {
    if (types == allLineTypes) return "all";
    std::vector<std::string_view> names;
    for (const auto& choice : lineTypeChoices) {
        if (types.contains(choice.value)) names.push_back(choice.name);
    }
    return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ","));
}

// N, or u:N,v:M with one or both.
Isolines parseIsolines(std::string_view text) {
    static constexpr int most = 1000;
    const auto steps = [](std::string_view number) {
        const int count = parseCount(number);
        if (count > most) throw Expected{fmt::format("whole numbers from 0 to {}", most)};
        return count;
    };
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

std::string text(const Isolines& isolines) {
    return isolines.u == isolines.v ? fmt::format("{}", isolines.u) : fmt::format("u:{},v:{}", isolines.u, isolines.v);
}

// TYPE:width=W,color=C;TYPE:...
std::array<LineStyle, lineTypeCount> parseLineStyles(std::string_view text) {
    std::array<LineStyle, lineTypeCount> styles;
    for (const std::string_view part : split(text, ';')) {
        const std::size_t colon = part.find(':');
        const Expected expected{"TYPE:width=W,color=C;... with one or both of width and color"};
        if (colon == std::string_view::npos) throw expected;
        const LineType type = parseChoice(lineTypeChoices, part.substr(0, colon));
        LineStyle& style = styles[static_cast<std::size_t>(bitIndex(type))];
        for (const std::string_view field : split(part.substr(colon + 1), ',')) {
            if (field.starts_with("width=")) {
                style.width = parseLength(field.substr(6));
            } else if (field.starts_with("color=")) {
                style.color = parseColor(field.substr(6));
            } else {
                throw expected;
            }
        }
    }
    return styles;
}

std::string lineStylesText(const std::array<LineStyle, lineTypeCount>& styles) {
    std::vector<std::string> parts;
    for (std::size_t i = 0; i < styles.size(); ++i) {
        std::vector<std::string> fields;
        if (styles[i].width) fields.push_back("width=" + text(*styles[i].width));
        if (styles[i].color) fields.push_back("color=" + text(*styles[i].color));
        if (!fields.empty()) parts.push_back(fmt::format("{}:{}", lineTypeChoices[i].name, fmt::join(fields, ",")));
    }
    return fmt::format("{}", fmt::join(parts, ";"));
}

std::vector<FunctionSettings> parseFunctions(std::string_view text) {
    std::vector<FunctionSettings> functions;
    for (const std::string_view part : split(text, ';')) {
        try {
            functions.push_back(surfaceFunction(part.substr(std::min(part.find_first_not_of(' '), part.size()))));
        } catch (const Error& error) {
            throw Refused{error.what()};
        }
    }
    return functions;
}

std::string functionsText(const std::vector<FunctionSettings>& functions) {
    std::vector<std::string> parts;
    for (const FunctionSettings& function : functions) parts.push_back(text(function));
    return fmt::format("{}", fmt::join(parts, ";"));
}

// A step of 1 has magnitude 4 under the Sobel kernels and d1 + d2 of equation 8 under Farid's.
constexpr float sobelStep = 4.0F;
constexpr float faridStep = 0.388734F;
constexpr Thresholds sobelThresholds{0.1F, 1.6F};

using S = Settings;
using Text = std::string_view;

constexpr std::array table{
    SettingDescription{"maps", "", "output", "MAP,...", "depth, normal, depth-edges, normal-edges, edges, types, ids",
                       "", "maps to write beside the picture; layers of one file if it is an EXR",
                       [](S& s, Text t) { s.maps = parseMaps(t); }, [](const S& s) { return text(s.maps); }},

    SettingDescription{"size", "", "picture", "WIDTHxHEIGHT", "1x1 to 32768x32768", "1024x1024",
                       "picture size in pixels", [](S& s, Text t) { s.picture.size = parseSize(t); },
                       [](const S& s) { return fmt::format("{}x{}", s.picture.size.width, s.picture.size.height); }},
    SettingDescription{"line-color", "", "picture", "COLOR", "#RGB, #RRGGBB or a name", "black", "colour of the lines",
                       [](S& s, Text t) { s.picture.lineColor = parseColor(t); },
                       [](const S& s) { return text(s.picture.lineColor); }},
    SettingDescription{
        "background", "", "picture", "COLOR|none", "#RGB, #RRGGBB, a name or none", "white",
        "colour behind the lines; none is transparent",
        [](S& s, Text t) { s.picture.background = t == "none" ? std::nullopt : std::optional{parseColor(t)}; },
        [](const S& s) { return s.picture.background ? text(*s.picture.background) : std::string{"none"}; }},

    SettingDescription{"line-width", "", "picture", "PX", "0.5 to 32, or millimetres: 0.35mm", "1.5",
                       "width of the lines in output pixels, or in mm at --dpi; planes detector",
                       [](S& s, Text t) { s.picture.lineWidth = parseLength(t); },
                       [](const S& s) { return text(s.picture.lineWidth); }},
    SettingDescription{"dpi", "", "picture", "N", "over 0", "96", "pixels an inch, for widths in mm",
                       [](S& s, Text t) { s.picture.dpi = parsePositive(t); },
                       [](const S& s) { return text(s.picture.dpi); }},
    SettingDescription{
        "page-size", "", "picture", "WIDTHxHEIGHT",
        "210mmx297mm, cm or in; A0 to A6, Letter, Legal, "
        "Tabloid; A4-landscape",
        "the size at --dpi", "sheet that an SVG fills as far as its shape allows; widths in mm hold on it",
        [](S& s, Text t) { s.picture.page = parsePage(t); }, [](const S& s) { return text(s.picture.page); }},
    SettingDescription{"supersampling", "", "picture", "1|2|4", "one of these", "1",
                       "samples a pixel along each axis, for detail below a pixel; planes detector",
                       [](S& s, Text t) {
                           const int samples = parseCount(t);
                           if (samples != 1 && samples != 2 && samples != 4) throw Expected{"1, 2 or 4"};
                           s.picture.supersampling = samples;
                       },
                       [](const S& s) { return text(s.picture.supersampling); }},
    SettingDescription{"tile-size", "", "picture", "SAMPLES", "256 to 8192", "4096",
                       "larger pictures are drawn in parts of at most this side: less needs less memory",
                       [](S& s, Text t) {
                           s.picture.tileSize =
                               parseCount(t, PictureSettings::leastTileSize, PictureSettings::mostTileSize);
                       },
                       [](const S& s) { return text(s.picture.tileSize); }},
    SettingDescription{
        "lines", "", "picture", "TYPE,...",
        "outline, occlusion, boundary, crease, intersection, object, isoparametric, marked; or all, none", "all",
        "types of lines that are drawn; planes detector", [](S& s, Text t) { s.picture.lines = parseLineTypes(t); },
        [](const S& s) { return lineTypesText(s.picture.lines); }},
    SettingDescription{"line-style", "", "picture", "TYPE:width=W,color=C;...", "types as for --lines", "",
                       "width and colour of single types of lines, as in crease:width=1,color=#555; planes detector",
                       [](S& s, Text t) { s.picture.lineStyles = parseLineStyles(t); },
                       [](const S& s) { return lineStylesText(s.picture.lineStyles); }},

    SettingDescription{"lines-from", "", "lines", "auto|image|object", "one of these", "auto",
                       "image: between pixels; object: exact lines of the mesh; auto: object for .svg and .json",
                       [](S& s, Text t) { s.lines.from = parseChoice(linesFromChoices, t); },
                       [](const S& s) { return choiceName(linesFromChoices, s.lines.from); }},
    SettingDescription{"contour", "", "lines", "auto|mesh|smooth", "one of these", "auto",
                       "contours: edges of the mesh, or curves where the shading normal turns away; lines from object",
                       [](S& s, Text t) { s.lines.contour = parseChoice(contourChoices, t); },
                       [](const S& s) { return choiceName(contourChoices, s.lines.contour); }},
    SettingDescription{
        "contour-finder", "", "lines", "every|random|gauss", "one of these", "every",
        "every edge, a random search that may miss some, or a map for orthographic views; lines from object",
        [](S& s, Text t) { s.lines.contourFinder = parseChoice(contourFinderChoices, t); },
        [](const S& s) { return choiceName(contourFinderChoices, s.lines.contourFinder); }},
    SettingDescription{"visibility", "", "lines", "exact|fast", "one of these", "exact",
                       "hidden lines found by rays, or by drawn buffers with rays in doubt; lines from object",
                       [](S& s, Text t) { s.lines.visibility = parseChoice(visibilityChoices, t); },
                       [](const S& s) { return choiceName(visibilityChoices, s.lines.visibility); }},
    SettingDescription{"hidden", "", "lines", "none|dashed|solid", "one of these", "none",
                       "how hidden lines are drawn; lines from object",
                       [](S& s, Text t) { s.lines.hidden = parseChoice(hiddenChoices, t); },
                       [](const S& s) { return choiceName(hiddenChoices, s.lines.hidden); }},
    SettingDescription{"stroke-width", "", "lines", "constant|depth|curvature", "one of these", "constant",
                       "wider where nearer, or where straighter: half to one and a half widths; lines from object",
                       [](S& s, Text t) { s.lines.strokeWidth = parseChoice(strokeWidthChoices, t); },
                       [](const S& s) { return choiceName(strokeWidthChoices, s.lines.strokeWidth); }},
    SettingDescription{"stroke-taper", "", "lines", "PX", "0 to 1000", "0",
                       "pixels over which ends where no line goes on or meets run out to nothing; lines from object",
                       [](S& s, Text t) { s.lines.strokeTaper = parseNumber(t, 0.0, 1000.0); },
                       [](const S& s) { return text(s.lines.strokeTaper); }},
    SettingDescription{"brush", "", "lines", "FILE", "a PNG, dark is ink", "",
                       "texture repeated along each line, its height across the line's width; lines from object",
                       [](S& s, Text t) { s.lines.brush = t; }, [](const S& s) { return s.lines.brush.string(); }},
    SettingDescription{"simplify", "", "lines", "PX", "0 to 100; 0 keeps every point", "0.25",
                       "how far polylines in .svg and .json may stray from the lines found",
                       [](S& s, Text t) { s.lines.simplify = parseNumber(t, 0.0, 100.0); },
                       [](const S& s) { return text(s.lines.simplify); }},
    SettingDescription{"fit-curves", "", "lines", "PX", "0, or 0.01 to 100", "0",
                       "cubic curves in .svg that stray from the lines no further than this; 0: polylines",
                       [](S& s, Text t) {
                           const double tolerance = parseNumber(t, 0.0, 100.0);
                           if (tolerance > 0.0 && tolerance < 0.01) throw Expected{"0 or a number from 0.01 to 100"};
                           s.lines.fitCurves = tolerance;
                       },
                       [](const S& s) { return text(s.lines.fitCurves); }},
    SettingDescription{"subdivide-adaptive", "", "lines", "N", "0 to 6", "0",
                       "refine N times, but only the faces that the contour may cross; lines from object",
                       [](S& s, Text t) { s.lines.subdivideAdaptive = parseLevels(t); },
                       [](const S& s) { return text(s.lines.subdivideAdaptive); }},
    SettingDescription{"isolines", "", "lines", "N|u:N,v:N", "0 to 1000", "0",
                       "lines at N steps of each texture coordinate's unit; lines from object",
                       [](S& s, Text t) { s.lines.isolines = parseIsolines(t); },
                       [](const S& s) { return text(s.lines.isolines); }},

    SettingDescription{"style", "", "style", "ink|hatch|sumi|pencil", "one of these", "ink",
                       "ink: lines as found; hatch: and marks where facets bend; sumi: a soft brush in place of lines; "
                       "pencil: loose strokes; pictures only",
                       [](S& s, Text t) { s.style.style = parseChoice(styleChoices, t); },
                       [](const S& s) { return choiceName(styleChoices, s.style.style); }},
    SettingDescription{"hatch-bend", "", "style", "DEG", "0.1 to 90", "the mesh's typical bend",
                       "facets that bend by this much give a dark mark in half light; hatch",
                       [](S& s, Text t) { s.style.hatchBend = parseNumber(t, 0.1, 90.0); },
                       [](const S& s) { return text(s.style.hatchBend); }},
    SettingDescription{"hatch-shade", "", "style", "X", "0 to 1", "1",
                       "0: marks everywhere alike; 1: few in the light, from the upper left, many in the dark; hatch",
                       [](S& s, Text t) { s.style.hatchShade = parseNumber(t, 0.0, 1.0); },
                       [](const S& s) { return text(s.style.hatchShade); }},
    SettingDescription{"hatch-width", "", "style", "PX", "0.25 to 2", "0.75", "width of marks; hatch",
                       [](S& s, Text t) { s.style.hatchWidth = parseNumber(t, 0.25, 2.0); },
                       [](const S& s) { return text(s.style.hatchWidth); }},
    SettingDescription{"sumi-width", "", "style", "PX", "1 to 32", "6", "width of the brush; sumi",
                       [](S& s, Text t) { s.style.sumiWidth = parseNumber(t, 1.0, 32.0); },
                       [](const S& s) { return text(s.style.sumiWidth); }},
    SettingDescription{"sumi-length", "", "style", "PX", "0 to 100", "24",
                       "how far ink is smeared along an edge, each way; sumi",
                       [](S& s, Text t) { s.style.sumiLength = parseNumber(t, 0.0, 100.0); },
                       [](const S& s) { return text(s.style.sumiLength); }},
    SettingDescription{"sumi-streaks", "", "style", "N", "0 to 4096", "0",
                       "steps that depth is sampled in, each of which leaves a streak; 0: none; sumi",
                       [](S& s, Text t) { s.style.sumiStreaks = parseCount(t, 0, 4096); },
                       [](const S& s) { return text(s.style.sumiStreaks); }},
    SettingDescription{"pencil-strokes", "", "style", "N", "1 to 8", "3", "how often each line is drawn; pencil",
                       [](S& s, Text t) { s.style.pencilStrokes = parseCount(t, 1, 8); },
                       [](const S& s) { return text(s.style.pencilStrokes); }},
    SettingDescription{"pencil-looseness", "", "style", "PX", "0 to 32", "3", "how far strokes stray; pencil",
                       [](S& s, Text t) { s.style.pencilLooseness = parseNumber(t, 0.0, 32.0); },
                       [](const S& s) { return text(s.style.pencilLooseness); }},
    SettingDescription{"pencil-seed", "", "style", "N", "0 to 65535", "1",
                       "of chance: strokes stray the same way in every picture of one seed; pencil",
                       [](S& s, Text t) { s.style.pencilSeed = parseCount(t, 0, 65535); },
                       [](const S& s) { return text(s.style.pencilSeed); }},

    SettingDescription{"camera-position", "eye", "camera", "X,Y,Z", "any point", "frames the model",
                       "where the camera stands, world space", [](S& s, Text t) { s.camera.position = parseVector(t); },
                       [](const S& s) { return text(s.camera.position); }},
    SettingDescription{"camera-focal-point", "target", "camera", "X,Y,Z", "any point but the position",
                       "the model's centre", "what the camera looks at, world space",
                       [](S& s, Text t) { s.camera.focalPoint = parseVector(t); },
                       [](const S& s) { return text(s.camera.focalPoint); }},
    SettingDescription{"camera-view-up", "up", "camera", "X,Y,Z", "not along the view direction", "0,1,0",
                       "which way is up in the picture, world space",
                       [](S& s, Text t) { s.camera.viewUp = parseVector(t); },
                       [](const S& s) { return text(s.camera.viewUp); }},
    SettingDescription{"camera-view-angle", "fov", "camera", "DEG", "over 0, under 180", "35",
                       "vertical view angle, degrees",
                       [](S& s, Text t) {
                           const double angle = parseNumber(t);
                           if (angle <= 0.0 || angle >= 180.0) throw Expected{"degrees over 0 and under 180"};
                           s.camera.viewAngle = angle;
                       },
                       [](const S& s) { return text(s.camera.viewAngle); }},
    SettingDescription{
        "camera-orthographic", "", "camera", "HEIGHT", "0 or more", "perspective",
        "orthographic view, HEIGHT scene units tall; 0 frames the model",
        [](S& s, Text t) { s.camera.orthographicHeight = parseNumber(t, 0.0, std::numeric_limits<double>::max()); },
        [](const S& s) { return text(s.camera.orthographicHeight); }},
    SettingDescription{"camera-direction", "", "camera", "X,Y,Z", "not 0,0,0", "three-quarter view",
                       "view direction, from the camera into the scene",
                       [](S& s, Text t) { s.camera.direction = parseVector(t); },
                       [](const S& s) { return text(s.camera.direction); }},
    SettingDescription{"camera-azimuth-angle", "azimuth", "camera", "DEG", "any angle", "30",
                       "view from this angle about +Y, from the front (+Z) towards +X",
                       [](S& s, Text t) { s.camera.azimuthAngle = parseNumber(t); },
                       [](const S& s) { return text(s.camera.azimuthAngle); }},
    SettingDescription{"camera-elevation-angle", "elevation", "camera", "DEG", "-90 to 90", "20",
                       "view from this angle above the horizon",
                       [](S& s, Text t) { s.camera.elevationAngle = parseNumber(t, -90.0, 90.0); },
                       [](const S& s) { return text(s.camera.elevationAngle); }},
    SettingDescription{"camera-index", "", "camera", "N", "0 to the file's last camera", "none", "a camera of the file",
                       [](S& s, Text t) { s.camera.index = parseCount(t); },
                       [](const S& s) { return text(s.camera.index); }},
    SettingDescription{"camera-zoom-factor", "zoom", "camera", "FACTOR", "over 0", "1", "over 1 magnifies",
                       [](S& s, Text t) { s.camera.zoomFactor = parsePositive(t); },
                       [](const S& s) { return text(s.camera.zoomFactor); }},

    SettingDescription{"normals", "", "model", "auto|authored|flat", "one of these", "auto",
                       "auto: the file's, smooth ones where it has none; authored: flat where it has none",
                       [](S& s, Text t) { s.load.normals = parseChoice(normalsChoices, t); },
                       [](const S& s) { return choiceName(normalsChoices, s.load.normals); }},
    SettingDescription{"crease-angle", "", "model", "DEG", "0 to 180", "30",
                       "faces that meet at more than this meet in a crease",
                       [](S& s, Text t) { s.load.creaseAngle = parseNumber(t, 0.0, 180.0); },
                       [](const S& s) { return text(s.load.creaseAngle); }},
    SettingDescription{"scene", "", "model", "N", "0 to the glTF file's last", "the file's default scene",
                       "which of the file's scenes to draw", [](S& s, Text t) { s.load.scene = parseCount(t); },
                       [](const S& s) { return text(s.load.scene); }},
    SettingDescription{"animation", "", "model", "NAME|N", "an animation of the glTF file", "",
                       "pose the model as an animation of the file does", [](S& s, Text t) { s.load.animation = t; },
                       [](const S& s) { return s.load.animation; }},
    SettingDescription{"time", "", "model", "SECONDS", "0 or more", "0", "when in the animation",
                       [](S& s, Text t) { s.load.time = parseNumber(t, 0.0, 1e9); },
                       [](const S& s) { return text(s.load.time); }},
    SettingDescription{"transparent", "", "model", "solid|ignore", "one of these", "solid",
                       "what becomes of materials that blend with what lies behind them",
                       [](S& s, Text t) { s.load.transparent = parseChoice(transparentChoices, t); },
                       [](const S& s) { return choiceName(transparentChoices, s.load.transparent); }},
    SettingDescription{"alpha-mask", "", "model", "cut|ignore", "one of these", "cut",
                       "cut materials with holes out along their outline, or draw them whole",
                       [](S& s, Text t) { s.load.alphaMask = parseChoice(alphaMaskChoices, t); },
                       [](const S& s) { return choiceName(alphaMaskChoices, s.load.alphaMask); }},
    SettingDescription{"back-faces", "", "model", "draw|material", "one of these", "draw",
                       "draw the backs of all faces, or only those of double-sided materials",
                       [](S& s, Text t) { s.load.backFaces = parseChoice(backFacesChoices, t); },
                       [](const S& s) { return choiceName(backFacesChoices, s.load.backFaces); }},
    SettingDescription{"subdivide", "", "model", "N", "0 to 6", "0",
                       "refine every mesh N times into the smooth surface that it controls; creases stay sharp",
                       [](S& s, Text t) { s.load.subdivide = parseLevels(t); },
                       [](const S& s) { return text(s.load.subdivide); }},
    SettingDescription{"max-file-size", "", "limits", "BYTES", "1 to 1099511627776; k, M, G may follow", "2147483647",
                       "most bytes of a model and the files that belong to it",
                       [](S& s, Text t) { s.load.limits.fileSize = parseAmount(t); },
                       [](const S& s) { return text(s.load.limits.fileSize); }},
    SettingDescription{"max-decompressed-size", "", "limits", "BYTES", "1 to 1099511627776; k, M, G may follow",
                       "1073741824", "most bytes that compressed geometry comes to",
                       [](S& s, Text t) { s.load.limits.decompressedSize = parseAmount(t); },
                       [](const S& s) { return text(s.load.limits.decompressedSize); }},
    SettingDescription{"max-vertices", "", "limits", "N", "1 to 4000000000; k, M, G may follow", "134217728",
                       "most vertices and indices of all meshes",
                       [](S& s, Text t) { s.load.limits.vertices = parseAmount(t, 4'000'000'000); },
                       [](const S& s) { return text(s.load.limits.vertices); }},
    SettingDescription{"max-instances", "", "limits", "N", "1 to 1099511627776; k, M, G may follow", "16777216",
                       "most meshes drawn, counted each time",
                       [](S& s, Text t) { s.load.limits.instances = parseAmount(t); },
                       [](const S& s) { return text(s.load.limits.instances); }},
    SettingDescription{"max-nodes", "", "limits", "N", "1 to 1099511627776; k, M, G may follow", "4194304",
                       "most nodes of a glTF file", [](S& s, Text t) { s.load.limits.nodes = parseAmount(t); },
                       [](const S& s) { return text(s.load.limits.nodes); }},
    SettingDescription{"max-node-depth", "", "limits", "N", "1 to 1099511627776; k, M, G may follow", "1048576",
                       "most nodes from a root down", [](S& s, Text t) { s.load.limits.nodeDepth = parseAmount(t); },
                       [](const S& s) { return text(s.load.limits.nodeDepth); }},
    SettingDescription{"max-image-pixels", "", "limits", "N", "1 to 1099511627776; k, M, G may follow", "67108864",
                       "most pixels of a picture that a material needs",
                       [](S& s, Text t) { s.load.limits.imagePixels = parseAmount(t); },
                       [](const S& s) { return text(s.load.limits.imagePixels); }},

    SettingDescription{"detector", "", "detector", "planes|classic|saito-takahashi|none", "one of these", "planes",
                       "planes: where visible faces do not go on; classic: gradients of depth and normals; "
                       "saito-takahashi: profiles and edges of depth; none: functions alone",
                       [](S& s, Text t) { s.detector.detector = parseChoice(detectorChoices, t); },
                       [](const S& s) { return choiceName(detectorChoices, s.detector.detector); }},
    SettingDescription{"kernel", "", "detector", "sobel|farid", "one of these", "sobel",
                       "gradient kernels: Sobel 3x3 (eq. 5) or Farid-Simoncelli 5x5 (eq. 8); classic detector",
                       [](S& s, Text t) { s.detector.kernel = parseChoice(kernelChoices, t); },
                       [](const S& s) { return choiceName(kernelChoices, s.detector.kernel); }},
    SettingDescription{"depth-map", "", "detector", "linear|window", "one of these", "linear",
                       "depth that edges are found in: eye-space scaled to 0..1, or window-space; classic detector",
                       [](S& s, Text t) { s.detector.depthMap = parseChoice(depthMapChoices, t); },
                       [](const S& s) { return choiceName(depthMapChoices, s.detector.depthMap); }},
    SettingDescription{"depth-threshold", "", "detector", "T", "0 or more", "0.1 (sobel), 0.00972 (farid)",
                       "depth edge where the magnitude (eq. 6) is at least T (eq. 7); classic detector",
                       [](S& s, Text t) { s.detector.depthThreshold = static_cast<float>(parseNumber(t, 0.0, 1e6)); },
                       [](const S& s) { return text(s.detector.depthThreshold); }},
    SettingDescription{"normal-threshold", "", "detector", "T", "0 or more", "1.6 (sobel), 0.155 (farid)",
                       "normal edge where the magnitude of any channel is at least T; classic detector",
                       [](S& s, Text t) { s.detector.normalThreshold = static_cast<float>(parseNumber(t, 0.0, 1e6)); },
                       [](const S& s) { return text(s.detector.normalThreshold); }},
    SettingDescription{"normal-lights", "", "detector", "single|two-pass", "one of these", "single",
                       "normal map from six lights in one float pass, or from two 8-bit passes",
                       [](S& s, Text t) { s.detector.normalLights = parseChoice(lightsChoices, t); },
                       [](const S& s) { return choiceName(lightsChoices, s.detector.normalLights); }},
    SettingDescription{"light-space", "", "detector", "camera|world", "one of these", "camera",
                       "the axes that the lights stand on",
                       [](S& s, Text t) { s.detector.lightSpace = parseChoice(lightSpaceChoices, t); },
                       [](const S& s) { return choiceName(lightSpaceChoices, s.detector.lightSpace); }},
    SettingDescription{"profile-limit", "", "detector", "PX", "0.001 to 1000", "10",
                       "depth, in pixels, over which a profile is full ink; saito-takahashi detector",
                       [](S& s, Text t) { s.detector.profileLimit = parseNumber(t, 0.001, 1000.0); },
                       [](const S& s) { return text(s.detector.profileLimit); }},
    SettingDescription{"edge-limit", "", "detector", "X", "0.001 to 1000", "0.6",
                       "change of slope over which an internal edge is full ink; saito-takahashi detector",
                       [](S& s, Text t) { s.detector.edgeLimit = parseNumber(t, 0.001, 1000.0); },
                       [](const S& s) { return text(s.detector.edgeLimit); }},
    SettingDescription{"function", "", "detector", "NAME[:key=value,...]",
                       "depth, normal, texture, base-color, environment, volume, curvature, uv, height, custom:FILE; "
                       "several: ; between them, or the flag again",
                       "", "surface function whose edges are drawn over the detector's lines",
                       [](S& s, Text t) { s.detector.functions = parseFunctions(t); },
                       [](const S& s) { return functionsText(s.detector.functions); }, ';'},

    SettingDescription{"backend", "", "backend", "auto|egl|osmesa", "one of these", "auto",
                       "how the OpenGL context is made; auto: egl, then osmesa",
                       [](S& s, Text t) { s.backend.backend = parseChoice(backendChoices, t); },
                       [](const S& s) { return choiceName(backendChoices, s.backend.backend); }},
    SettingDescription{"device", "", "backend", "N", "0 to the last that inkedge doctor lists",
                       "hardware before software", "EGL device", [](S& s, Text t) { s.backend.device = parseCount(t); },
                       [](const S& s) { return text(s.backend.device); }},
};

}  // namespace

LoadSettings loadSettings(const Settings& settings) {
    LoadSettings load = settings.load;
    const bool drawsIsolines = settings.picture.lines.contains(LineType::Isoparametric);
    load.textureCoordinates = load.textureCoordinates || (drawsIsolines && settings.lines.isolines != Isolines{});
    for (const FunctionSettings& function : settings.detector.functions) {
        const FunctionNeeds& needs = functionDescription(function.name).needs;
        load.textureCoordinates = load.textureCoordinates || needs.coordinates;
        load.paint = load.paint || needs.paint;
        load.curvature = load.curvature || needs.curvature;
    }
    return load;
}

Thresholds thresholds(const DetectorSettings& detector) noexcept {
    const float scale = detector.kernel == Kernel::Sobel ? 1.0F : faridStep / sobelStep;
    return {detector.depthThreshold.value_or(sobelThresholds.depth * scale),
            detector.normalThreshold.value_or(sobelThresholds.normal * scale)};
}

std::string_view name(LineType type) noexcept {
    const auto* const choice = std::ranges::find(lineTypeChoices, type, &Choice<LineType>::value);
    return choice == lineTypeChoices.end() ? std::string_view{} : choice->name;
}

std::string_view name(Map map) noexcept { return mapChoices[static_cast<std::size_t>(map)].name; }

std::span<const SettingDescription> settingTable() noexcept { return table; }

void set(Settings& settings, std::string_view name, std::string_view text, std::string_view source) {
    const auto* row = std::ranges::find(table, name, &SettingDescription::name);
    if (row == table.end()) {
        throw Error{Error::Kind::Usage, fmt::format("{}: there is no setting named '{}'", source, name)};
    }
    try {
        row->set(settings, text);
    } catch (const Expected& expected) {
        throw Error{Error::Kind::Usage, fmt::format("{}: expected {}, found '{}'", source, expected.what, text)};
    } catch (const Refused& refused) {
        throw Error{Error::Kind::Usage, fmt::format("{}: {}", source, refused.why)};
    }
}

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all{
        {"paper", "the classic detector with the 5x5 kernels", {{"detector", "classic"}, {"kernel", "farid"}}},
        {"blueprint", "white lines on blue", {{"line-color", "#ffffff"}, {"background", "#1f4e8c"}}},
        {"overlay", "black lines on nothing", {{"line-color", "#000000"}, {"background", "none"}}},
    };
    return all;
}

}  // namespace inkedge
