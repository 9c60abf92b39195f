#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::line_maps {

inline const std::string assets = INKEDGE_SOURCE_DIR "/assets/";

inline constexpr unsigned bit(LineType type) { return static_cast<unsigned>(type); }
inline constexpr unsigned outline = bit(LineType::Outline);
inline constexpr unsigned occlusion = bit(LineType::Occlusion);
inline constexpr unsigned boundary = bit(LineType::Boundary);
inline constexpr unsigned crease = bit(LineType::Crease);
inline constexpr unsigned intersection = bit(LineType::Intersection);
inline constexpr unsigned object = bit(LineType::Object);

inline Settings linesOf(Size size, std::vector<Map> maps = {Map::Types}) {
    Settings settings;
    settings.picture.size = size;
    settings.maps = std::move(maps);
    return settings;
}

template <class T>
int countMarked(const Image<T>& map) {
    return static_cast<int>(std::ranges::count_if(map.pixels(), [](T value) { return value != 0; }));
}

}  // namespace inkedge::line_maps
