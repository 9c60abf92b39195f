#include <fmt/format.h>

#include "settings/constraints.h"
#include "settings/idle.h"
#include "settings/rows.h"

namespace inkedge::settings {
namespace {

constexpr std::array<std::string_view, 5> styleNames{"ink", "hatch", "sumi", "pencil", "none"};
constexpr std::array<std::string_view, 5> shadeNames{"none", "flat", "gooch", "light", "base-color"};

std::string lightRange() { return fmt::format("{}; {}; degrees", rangeOf(lightAzimuth), rangeOf(lightElevation)); }

}  // namespace

std::vector<SettingDescription> styleRows() {
    return inGroup(
        "style",
        {row(
             {.name = "style",
              .help = "ink: lines as found; hatch: and marks where facets bend; sumi: a soft brush in place of lines; "
                      "pencil: loose strokes; none: no lines; pictures only"},
             Choice{styleNames}, [](auto& s) -> auto& { return s.style.style; }),
         row(
             {.name = "hatch-bend",
              .help = "facets that bend by this much give a dark mark in half light; hatch",
              .defaultInWords = "the mesh's typical bend",
              .idle = idleStyle<Style::Hatch>},
             Number{.min = 0.1, .max = 90.0, .unit = "DEG"}, [](auto& s) -> auto& { return s.style.hatchBend; }),
         row(
             {.name = "hatch-shade",
              .help = "0: marks everywhere alike; 1: few in the light, from the upper left, many in the dark; hatch",
              .idle = idleStyle<Style::Hatch>},
             Number{.min = 0.0, .max = 1.0, .unit = "X"}, [](auto& s) -> auto& { return s.style.hatchShade; }),
         row(
             {.name = "hatch-width", .help = "width of marks; hatch", .idle = idleStyle<Style::Hatch>},
             Number{.min = 0.25, .max = 2.0, .unit = "PX"}, [](auto& s) -> auto& { return s.style.hatchWidth; }),
         row(
             {.name = "sumi-width", .help = "width of the brush; sumi", .idle = idleStyle<Style::Sumi>},
             Number{.min = 1.0, .max = 32.0, .unit = "PX"}, [](auto& s) -> auto& { return s.style.sumiWidth; }),
         row(
             {.name = "sumi-length",
              .help = "how far ink is smeared along an edge, each way; sumi",
              .idle = idleStyle<Style::Sumi>},
             Number{.min = 0.0, .max = 100.0, .unit = "PX"}, [](auto& s) -> auto& { return s.style.sumiLength; }),
         row(
             {.name = "sumi-streaks",
              .help = "steps that depth is sampled in, each of which leaves a streak; 0: none; sumi",
              .idle = idleStyle<Style::Sumi>},
             Count{.max = 4096}, [](auto& s) -> auto& { return s.style.sumiStreaks; }),
         row(
             {.name = "pencil-strokes",
              .help = "how often each line is drawn; pencil",
              .idle = idleStyle<Style::Pencil>},
             Count{.min = 1, .max = 8}, [](auto& s) -> auto& { return s.style.pencilStrokes; }),
         row(
             {.name = "pencil-looseness", .help = "how far strokes stray; pencil", .idle = idleStyle<Style::Pencil>},
             Number{.min = 0.0, .max = 32.0, .unit = "PX"}, [](auto& s) -> auto& { return s.style.pencilLooseness; }),
         row(
             {.name = "pencil-seed",
              .help = "of chance: strokes stray the same way in every picture of one seed; pencil",
              .idle = idleStyle<Style::Pencil>},
             Count{.max = 65535}, [](auto& s) -> auto& { return s.style.pencilSeed; }),
         row(
             {.name = "shade",
              .help = "what fills surfaces under the lines: gooch: their own colour from cool to warm towards the "
                      "light; light, flat: lit, smoothly or by faces; base-color: their own colour",
              .idle = idleShade},
             Choice{shadeNames}, [](auto& s) -> auto& { return s.shade.shade; }),
         row<parseLight>(
             {.name = "light",
              .help = "where the light of --shade comes from, towards the right and upwards; on the axes of "
                      "--light-space: from the camera, or from the model's front",
              .idle = idleLight},
             {"AZIMUTH,ELEVATION", lightRange}, [](auto& s) -> auto& { return s.shade.light; })});
}

}  // namespace inkedge::settings
