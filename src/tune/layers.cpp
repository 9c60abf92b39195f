#include "tune/layers.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <inkedge/encode_png.h>
#include <inkedge/image.h>

#include "io/map_pictures.h"

namespace inkedge::tune {
namespace {

using Rgb = std::array<std::uint8_t, 3>;

constexpr Rgb white{255, 255, 255};

// Colours far from each other for numbers that follow each other: the hue goes on by the golden ratio.
Rgb colorOf(std::uint32_t number) {
    constexpr double goldenRatio = 0.618033988749895;
    const double hue = std::fmod(number * goldenRatio, 1.0) * 6.0;
    Rgb color{};
    for (std::size_t i = 0; i < color.size(); ++i) {
        const double away = std::abs(std::remainder(hue - 2.0 * static_cast<double>(i), 6.0));
        color[i] = static_cast<std::uint8_t>(255.0 - 150.0 * std::min(std::max(away - 1.0, 0.0), 1.0));
    }
    return color;
}

template <class Value>
Image<std::uint8_t> inColors(const Image<Value>& numbers) {
    Image<std::uint8_t> picture{numbers.size(), 3};
    std::uint8_t* to = picture.mutablePixels().data();
    const auto& from = numbers.pixels();
    for (std::size_t i = 0; i < from.size(); i += static_cast<std::size_t>(numbers.channels())) {
        for (const std::uint8_t value : from[i] == 0 ? white : colorOf(from[i])) *to++ = value;
    }
    return picture;
}

}  // namespace

std::vector<std::uint8_t> layerPicture(const Maps& maps, Map map) {
    if (map == Map::Ids) return encodePng(inColors(maps.ids), maps.dpi);
    if (map == Map::Types) return encodePng(inColors(maps.types), maps.dpi);
    return io::pngOf(maps, io::layersOf(maps, map).front(), "map.png");
}

}  // namespace inkedge::tune
