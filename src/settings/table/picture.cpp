#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settings/constraints.h"
#include "settings/idle.h"
#include "settings/rows.h"

namespace inkedge::settings {
namespace {

constexpr std::array samplesAlongAnAxis{1, 2, 4};
constexpr std::array<std::string_view, 2> normalSpaceNames{"camera", "world"};

SettingDescription::Field maps() {
    return {[](const Constraint& c, Settings& s, std::string_view text) {
                std::vector<Map> maps;
                for (const std::string_view part : split(text, ',')) {
                    const Map map = static_cast<Map>(parseChoice(std::get<List>(c).names, part));
                    if (std::ranges::find(maps, map) == maps.end()) maps.push_back(map);
                }
                s.maps = std::move(maps);
            },
            [](const Constraint& c, const Settings& s) {
                std::vector<std::string> names;
                for (const Map map : s.maps) names.push_back(nameOf(std::get<List>(c).names, static_cast<int>(map)));
                return fmt::format("{}", fmt::join(names, ","));
            }};
}

// Words for several types at once.
struct NamedTypes {
    std::string_view name;
    LineTypes types;
};
constexpr std::array namedTypes{NamedTypes{"all", allLineTypes}, NamedTypes{"standard", standardLineTypes}};

LineTypes typesOf(const List& list, std::string_view name) {
    const auto* const named = std::ranges::find(namedTypes, name, &NamedTypes::name);
    return named != namedTypes.end() ? named->types : static_cast<LineType>(1U << parseChoice(list.names, name));
}

SettingDescription::Field lineTypes() {
    return {[](const Constraint& c, Settings& s, std::string_view text) {
                LineTypes types;
                if (text != "none") {
                    for (const std::string_view part : split(text, ',')) types |= typesOf(std::get<List>(c), part);
                }
                s.picture.lines = types;
            },
            [](const Constraint& c, const Settings& s) {
                LineTypes rest = s.picture.lines;
                if (rest.empty()) return std::string{"none"};
                std::vector<std::string> names;
                for (const auto& [name, types] : namedTypes) {
                    if (!(types - rest).empty()) continue;
                    names.emplace_back(name);
                    rest = rest - types;
                }
                for (const LineType type : rest) names.push_back(nameOf(std::get<List>(c).names, bitIndex(type)));
                return fmt::format("{}", fmt::join(names, ","));
            }};
}

SettingDescription::Field background() {
    return {[](const Constraint&, Settings& s, std::string_view text) {
                const bool none = text == "none" || text == "transparent";
                s.picture.background = none ? std::nullopt : std::optional{parseColor(text)};
            },
            [](const Constraint&, const Settings& s) {
                return s.picture.background ? textOf(*s.picture.background) : std::string{"none"};
            }};
}

// A width and a height in pixels are PictureSettings::size.
SettingDescription::Field size() {
    static constexpr auto isPixels = [](const std::optional<PictureExtent>& extent) {
        return !extent || (!extent->millimetres && extent->height > 0.0);
    };
    return {[](const Constraint&, Settings& s, std::string_view text) {
                s.frame.size = parseExtent(text);
                if (isPixels(s.frame.size))
                    s.picture.size = {static_cast<int>(s.frame.size->width), static_cast<int>(s.frame.size->height)};
            },
            [](const Constraint&, const Settings& s) {
                return isPixels(s.frame.size) ? textOf(s.picture.size) : textOf(*s.frame.size);
            }};
}

SettingDescription::Field scale() {
    return {[](const Constraint&, Settings& s, std::string_view text) { s.frame.scale = parseScale(text); },
            [](const Constraint&, const Settings& s) {
                return s.frame.scale ? textOfScale(*s.frame.scale) : std::string{};
            }};
}

SettingDescription::Field lineStyle() {
    return {[](const Constraint&, Settings& s, std::string_view text) {
                const Pens pens = parsePens(text);
                s.picture.pens = pens.types;
                s.picture.hiddenPen = pens.hidden;
            },
            [](const Constraint&, const Settings& s) {
                return textOf(Pens{s.picture.pens, s.picture.hiddenPen});
            }};
}

std::string sizes() {
    return fmt::format(
        "{0}x{0} to {1}x{1} pixels; 90x60mm at --dpi, cm or in; a width alone, as 90mm: the height that "
        "what is drawn asks for",
        pictureSides.min, pictureSides.max);
}
std::string penWidths() { return rangeOf(penWidth) + ", or millimetres: 0.35mm"; }

}  // namespace

std::vector<SettingDescription> outputRows() {
    return inGroup(
        "output",
        {described({.name = "maps",
                    .help = "maps to write beside the picture; in one file if it is an .exr, or an .npz, which without "
                            "this flag holds depth, normal, types, ids and edges"},
                   List{mapNames, "MAP"}, maps()),
         row(
             {.name = "normal-space",
              .help = "the axes of the normal map: x right, y up, z towards the eye; or the world's",
              .idle = idleNormalSpace},
             Choice{normalSpaceNames}, [](auto& s) -> auto& { return s.normalSpace; })});
}

std::vector<SettingDescription> pictureRows() {
    return inGroup(
        "picture",
        {described(
             {.name = "size",
              .help = "size of the picture, in pixels or on paper; at --scale what is drawn takes unless it is given"},
             Custom{"WIDTH[xHEIGHT]", sizes, 'x'}, size()),
         row<parseMargin>(
             {.name = "crop",
              .help = "cut the picture to what is drawn and this margin, in pixels or mm; a --size is filled between "
                      "the margins"},
             {"MARGIN", [] { return std::string{"0 or more, or millimetres: 2mm"}; }},
             [](auto& s) -> auto& { return s.frame.crop; }),
         described({.name = "scale",
                    .help = "orthographic, PAPER lengths at --dpi for MODEL lengths; glTF is in metres, STL and other "
                            "files without a unit count as millimetres"},
                   Custom{"PAPER:MODEL", [] { return std::string{"1:2, 5:1, ..."}; }, ':'}, scale()),
         row<parseColor>(
             {.name = "line-color", .help = "colour of the lines", .defaultInWords = "black", .idle = idleLineColor},
             {"COLOR", [] { return std::string{"#RGB, #RRGGBB or a name"}; }},
             [](auto& s) -> auto& { return s.picture.lineColor; }),
         described({.name = "background",
                    .help = "colour behind the lines; none, or transparent, is no colour",
                    .defaultInWords = "white",
                    .idle = idleBackground},
                   Custom{"COLOR|none", [] { return std::string{"#RGB, #RRGGBB, a name, none or transparent"}; }},
                   background()),
         row<parseLength>(
             {.name = "line-width",
              .help = "width of the lines in output pixels, or in mm at --dpi; planes detector",
              .idle = idlePen},
             {"PX", penWidths}, [](auto& s) -> auto& { return s.picture.lineWidth; }),
         row(
             {.name = "dpi",
              .help = "pixels an inch, for what is in mm; files but EXR and JSON tell it",
              .defaultInWords = "96",
              .idle = idleDpi},
             Number{.min = 1.0, .max = 100'000.0, .unit = "N"}, [](auto& s) -> auto& { return s.picture.dpi; }),
         row<parsePage>(
             {.name = "page-size",
              .help = "page that an .svg, .pdf or .dxf fills as far as its shape allows, or in whose middle a picture "
                      "in mm or at --scale lies; widths in mm hold on it",
              .defaultInWords = "the size at --dpi",
              .idle = idlePage},
             {"WIDTHxHEIGHT",
              [] {
                  return std::string{
                      "210mmx297mm, cm or in; A0 to A6, Letter, Legal, Tabloid; "
                      "A4-landscape"};
              },
              'x'},
             [](auto& s) -> auto& { return s.picture.page; }),
         row(
             {.name = "supersampling",
              .help = "samples a pixel along each axis, for detail below a pixel; planes detector",
              .idle = idleSamples},
             Count{.choices = samplesAlongAnAxis}, [](auto& s) -> auto& { return s.picture.supersampling; }),
         row(
             {.name = "tile-size",
              .help = "larger pictures are drawn in parts of at most this side: less needs less memory"},
             Count{.min = PictureSettings::minTileSize, .max = PictureSettings::maxTileSize, .unit = "SAMPLES"},
             [](auto& s) -> auto& { return s.picture.tileSize; }),
         described({.name = "lines",
                    .help = "types of lines that are drawn; planes detector",
                    .rangeNote = "or standard, which is all but the four lines of form; all; none",
                    .idle = idleTypes},
                   List{lineTypeNames, "TYPE"}, lineTypes()),
         described(
             {.name = "line-style",
              .help = "width and colour of single types of lines, as in crease:width=1,color=#555, and of hidden "
                      "ones, as in hidden:width=0.25mm,dash=3mm:1.5mm; planes detector",
              .idle = idleLineStyle},
             Custom{"TYPE:width=W,color=C;...", [] { return std::string{"types as for --lines, and hidden"}; }, ';'},
             lineStyle())});
}

}  // namespace inkedge::settings
