#include "io/dxf_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace inkedge::io {
namespace {

constexpr int fullSaturation = 255;

// The colours 10 to 249 are hues 15 degrees apart, of five levels, each saturated and half of it.
Color hued(int index) {
    constexpr std::array levels{255, 165, 127, 76, 38};
    constexpr int stepsOfHue = 24;
    const int level = levels[static_cast<std::size_t>(index % 10 / 2)];
    const int low = index % 2 == 0 ? 0 : level / 2;
    const double hue = static_cast<double>(index / 10 - 1) / stepsOfHue;
    const auto channel = [&](double shift) {
        const double turn = std::abs(std::fmod(6.0 * (hue + shift), 6.0) - 3.0) - 1.0;
        return static_cast<std::uint8_t>(std::lround(low + std::clamp(turn, 0.0, 1.0) * (level - low)));
    };
    return {channel(0.0), channel(2.0 / 3.0), channel(1.0 / 3.0)};
}

std::array<Color, 256> makePalette() {
    constexpr std::uint8_t full = fullSaturation;
    std::array<Color, 256> palette{};
    const std::array<Color, 9> first{Color{full, 0, 0}, {full, full, 0}, {0, full, 0},    {0, full, full}, {0, 0, full},
                                     {full, 0, full},   {0, 0, 0},       {128, 128, 128}, {192, 192, 192}};
    std::ranges::copy(first, palette.begin() + 1);
    for (int i = 10; i < 250; ++i) palette[static_cast<std::size_t>(i)] = hued(i);
    const std::array<std::uint8_t, 6> greys{51, 91, 132, 173, 214, full};
    for (std::size_t i = 0; i < greys.size(); ++i) palette[250 + i] = {greys[i], greys[i], greys[i]};
    return palette;
}

int squaredDistance(Color a, Color b) {
    const auto square = [](int difference) { return difference * difference; };
    return square(a.red - b.red) + square(a.green - b.green) + square(a.blue - b.blue);
}

}  // namespace

int dxfColor(Color color) noexcept {
    static const std::array<Color, 256> palette = makePalette();
    if (color == Color{fullSaturation, fullSaturation, fullSaturation}) return 7;
    int nearest = 7;
    int distance = std::numeric_limits<int>::max();
    for (int i = 1; i < 256; ++i) {
        const int found = squaredDistance(color, palette[static_cast<std::size_t>(i)]);
        if (found >= distance) continue;
        nearest = i;
        distance = found;
    }
    return nearest;
}

int dxfLineWidth(double millimetres) noexcept {
    constexpr std::array widths{0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                                53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};
    return *std::ranges::min_element(widths, {}, [&](int width) { return std::abs(width - 100.0 * millimetres); });
}

}  // namespace inkedge::io
