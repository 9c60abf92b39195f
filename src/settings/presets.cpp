#include <inkedge/setting_table.h>

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>

#include "base/nearest_name.h"

namespace inkedge {

const std::vector<Preset>& presets() {
    static const std::vector<Preset> all{
        {"paper", "the classic detector with the 5x5 kernels", {{"detector", "classic"}, {"kernel", "farid"}}},
        {"blueprint", "white lines on blue", {{"line-color", "#ffffff"}, {"background", "#1f4e8c"}}},
        {"overlay", "black lines on nothing", {{"line-color", "#000000"}, {"background", "none"}}},
        {"technical",
         "a drawing for the workshop: wide outlines, fine inner lines, hidden ones dashed",
         {{"line-width", "0.35mm"},
          {"line-style", "outline:width=0.7mm;tangent:width=0.18mm;hidden:width=0.25mm"},
          {"lines-from", "object"},
          {"hidden", "dashed"}}},
        {"illustration",
         "heavy outlines, folds of smooth forms and tapering lines over cool and warm colours",
         {{"line-width", "1.5"},
          {"line-style", "outline:width=4;occlusion:width=2.5"},
          {"lines", "standard,suggestive,ridge,valley"},
          {"crease-angle", "50"},
          {"lines-from", "object"},
          {"stroke-width", "strength"},
          {"stroke-taper", "24"},
          {"supersampling", "2"},
          {"shade", "gooch"}}},
        {"plotter",
         "for a pen, as SVG: one width, no line twice, in an order of short ways",
         {{"line-width", "0.35mm"},
          {"background", "none"},
          {"lines-from", "object"},
          {"coincident", "merge"},
          {"path-order", "travel"}}},
        {"dataset",
         "all maps beside a lit picture without lines",
         {{"maps", "depth,normal,depth-edges,normal-edges,edges,types,ids,shade"},
          {"style", "none"},
          {"shade", "light"}}},
    };
    return all;
}

void setPreset(Settings& settings, std::string_view name, std::string_view source) {
    const auto found = std::ranges::find(presets(), name, &Preset::name);
    if (found == presets().end()) {
        std::vector<std::string_view> names;
        for (const Preset& preset : presets()) names.push_back(preset.name);
        throw Error{Error::Kind::Usage, fmt::format("{}: expected one of {}, found '{}'{}", source,
                                                    fmt::join(names, ", "), name, base::suggestion(name, names))};
    }
    for (const auto& [setting, text] : found->values) set(settings, setting, text, fmt::format("preset {}", name));
}

}  // namespace inkedge
