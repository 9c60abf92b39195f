#pragma once

#include <array>
#include <string_view>

#include <inkedge/settings.h>

namespace inkedge::settings {

/// In the order of Map.
inline constexpr std::array<std::string_view, mapCount> mapNames{"depth", "normal", "depth-edges", "normal-edges",
                                                                 "edges", "types",  "ids"};
/// In the order of LineType's bits.
inline constexpr std::array<std::string_view, lineTypeCount> lineTypeNames{
    "outline", "occlusion", "boundary", "crease", "intersection", "object", "isoparametric", "marked"};

}  // namespace inkedge::settings
