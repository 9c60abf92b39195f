#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "settings/constraints.h"
#include "settings/rows.h"

namespace inkedge::settings {
namespace {

constexpr std::array samplesAlongAnAxis{1, 2, 4};

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

SettingDescription::Field lineTypes() {
    return {[](const Constraint& c, Settings& s, std::string_view text) {
                LineTypes types = text == "all" ? allLineTypes : LineTypes{};
                if (text != "all" && text != "none") {
                    for (const std::string_view part : split(text, ','))
                        types |= static_cast<LineType>(1U << parseChoice(std::get<List>(c).names, part));
                }
                s.picture.lines = types;
            },
            [](const Constraint& c, const Settings& s) {
                if (s.picture.lines == allLineTypes) return std::string{"all"};
                std::vector<std::string> names;
                for (const LineType type : s.picture.lines)
                    names.push_back(nameOf(std::get<List>(c).names, bitIndex(type)));
                return names.empty() ? "none" : fmt::format("{}", fmt::join(names, ","));
            }};
}

SettingDescription::Field background() {
    return {[](const Constraint&, Settings& s, std::string_view text) {
                s.picture.background = text == "none" ? std::nullopt : std::optional{parseColor(text)};
            },
            [](const Constraint&, const Settings& s) {
                return s.picture.background ? textOf(*s.picture.background) : std::string{"none"};
            }};
}

std::string sizes() { return fmt::format("{0}x{0} to {1}x{1}", pictureSides.min, pictureSides.max); }
std::string penWidths() { return rangeOf(penWidth) + ", or millimetres: 0.35mm"; }

}  // namespace

std::vector<SettingDescription> outputRows() {
    return inGroup(
        "output",
        {described({.name = "maps", .help = "maps to write beside the picture; layers of one file if it is an EXR"},
                   List{mapNames, "MAP"}, maps())});
}

std::vector<SettingDescription> pictureRows() {
    return inGroup(
        "picture",
        {row<parseSize>(
             {.name = "size", .help = "picture size in pixels"}, {"WIDTHxHEIGHT", sizes},
             [](auto& s) -> auto& { return s.picture.size; }),
         row<parseColor>(
             {.name = "line-color", .help = "colour of the lines", .defaultInWords = "black"},
             {"COLOR", [] { return std::string{"#RGB, #RRGGBB or a name"}; }},
             [](auto& s) -> auto& { return s.picture.lineColor; }),
         described(
             {.name = "background", .help = "colour behind the lines; none is transparent", .defaultInWords = "white"},
             Custom{"COLOR|none", [] { return std::string{"#RGB, #RRGGBB, a name or none"}; }}, background()),
         row<parseLength>(
             {.name = "line-width", .help = "width of the lines in output pixels, or in mm at --dpi; planes detector"},
             {"PX", penWidths}, [](auto& s) -> auto& { return s.picture.lineWidth; }),
         row(
             {.name = "dpi", .help = "pixels an inch, for widths in mm"},
             Number{.min = 1.0, .max = 100'000.0, .unit = "N"}, [](auto& s) -> auto& { return s.picture.dpi; }),
         row<parsePage>(
             {.name = "page-size",
              .help = "sheet that an SVG fills as far as its shape allows; widths in mm hold on it",
              .defaultInWords = "the size at --dpi"},
             {"WIDTHxHEIGHT",
              [] {
                  return std::string{
                      "210mmx297mm, cm or in; A0 to A6, Letter, Legal, Tabloid; "
                      "A4-landscape"};
              }},
             [](auto& s) -> auto& { return s.picture.page; }),
         row(
             {.name = "supersampling",
              .help = "samples a pixel along each axis, for detail below a pixel; planes detector"},
             Count{.choices = samplesAlongAnAxis}, [](auto& s) -> auto& { return s.picture.supersampling; }),
         row(
             {.name = "tile-size",
              .help = "larger pictures are drawn in parts of at most this side: less needs less memory"},
             Count{.min = PictureSettings::minTileSize, .max = PictureSettings::maxTileSize, .unit = "SAMPLES"},
             [](auto& s) -> auto& { return s.picture.tileSize; }),
         described(
             {.name = "lines", .help = "types of lines that are drawn; planes detector", .rangeNote = "or all, none"},
             List{lineTypeNames, "TYPE"}, lineTypes()),
         row<parsePens>(
             {.name = "line-style",
              .help = "width and colour of single types of lines, as in crease:width=1,color=#555; planes detector"},
             {"TYPE:width=W,color=C;...", [] { return std::string{"types as for --lines"}; }},
             [](auto& s) -> auto& { return s.picture.pens; })});
}

}  // namespace inkedge::settings
