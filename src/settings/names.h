#pragma once

#include <array>
#include <string_view>

#include <inkedge/settings.h>

namespace inkedge::settings {

/// In the order of Map.
inline constexpr std::array<std::string_view, mapCount> mapNames{"depth", "normal", "depth-edges", "normal-edges",
                                                                 "edges", "types",  "ids",         "shade"};
/// In the order of LineType's bits.
inline constexpr std::array<std::string_view, lineTypeCount> lineTypeNames{
    "outline", "occlusion",  "boundary", "crease", "intersection", "object", "isoparametric",
    "marked",  "suggestive", "ridge",    "valley", "apparent",     "tangent"};

/// In the order of ContourFinder.
inline constexpr std::array<std::string_view, 3> contourFinderNames{"every", "random", "gauss"};
/// In the order of Detector.
inline constexpr std::array<std::string_view, 5> detectorNames{"planes", "classic", "saito-takahashi", "raskar-cohen",
                                                               "none"};

/// In the order of NamedView.
inline constexpr std::array<std::string_view, 8> namedViewNames{"front", "back",   "left", "right",
                                                                "top",   "bottom", "iso",  "dimetric"};

}  // namespace inkedge::settings
