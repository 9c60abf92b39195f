#pragma once

#include <algorithm>

#include <inkedge/settings.h>

namespace inkedge::settings {

[[nodiscard]] inline bool hasShadeMap(const RenderSettings& settings) {
    return std::ranges::find(settings.maps, Map::Shade) != settings.maps.end();
}

/// What is drawn under the lines or, if nothing is, for the map; Shade::None: neither asks for it.
[[nodiscard]] inline Shade drawnShade(const RenderSettings& settings) {
    const bool forMap = settings.shade.shade == Shade::None && hasShadeMap(settings);
    return forMap ? Shade::Gooch : settings.shade.shade;
}

}  // namespace inkedge::settings
