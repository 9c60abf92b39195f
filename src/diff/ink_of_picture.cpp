#include "diff/ink_of_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace inkedge::diff {
namespace {

constexpr int reach = 8;                // pixels: thinner than twice that and one is a line
constexpr float faintest = 0.06F;       // what stands out by less is noise, or a gradient of a fill
constexpr double strongestShare = 0.9;  // of the pixels that stand out are weaker than what counts as full ink

// One channel, alpha over white; what is no number is white.
Image<float> channel(const Image<float>& picture, int c) {
    Image<float> values{picture.size(), 1};
    for (int y = 0; y < picture.size().height; ++y) {
        for (int x = 0; x < picture.size().width; ++x) {
            const float alpha = picture.channels() == 4 ? picture(x, y, 3) : 1.0F;
            const float value = 1.0F + alpha * (picture(x, y, c) - 1.0F);
            values(x, y) = std::isfinite(value) ? std::clamp(value, 0.0F, 1.0F) : 1.0F;
        }
    }
    return values;
}

// The largest value within reach along a row of `count` values that are `step` apart. Each block of a window's length
// is scanned from both its ends: van Herk 1992.
void largestAlong(float* row, int count, std::ptrdiff_t step, std::vector<float>& forth, std::vector<float>& back) {
    constexpr int window = 2 * reach + 1;
    const auto padded = static_cast<std::size_t>((count + 2 * reach + window - 1) / window * window);
    forth.assign(padded, -1.0F);
    for (int i = 0; i < count; ++i) forth[static_cast<std::size_t>(i + reach)] = row[i * step];
    back = forth;
    for (std::size_t i = 1; i < padded; ++i)
        if (i % window != 0) forth[i] = std::max(forth[i], forth[i - 1]);
    for (std::size_t i = padded - 1; i-- > 0;)
        if (i % window != window - 1) back[i] = std::max(back[i], back[i + 1]);
    for (int i = 0; i < count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        row[i * step] = std::max(back[at], forth[at + 2 * reach]);
    }
}

Image<float> largestAround(Image<float> image) {
    std::vector<float> forth;
    std::vector<float> back;
    const auto [width, height] = image.size();
    float* const pixels = image.mutablePixels().data();
    for (int y = 0; y < height; ++y) largestAlong(pixels + std::ptrdiff_t{y} * width, width, 1, forth, back);
    for (int x = 0; x < width; ++x) largestAlong(pixels + x, height, width, forth, back);
    return image;
}

Image<float> negative(Image<float> image) {
    for (float& value : image.mutablePixels()) value = 1.0F - value;
    return image;
}

// How much darker each pixel is than what lies to two opposite sides of it: closing less the image.
void addDarkness(const Image<float>& image, Image<float>& darkness) {
    const Image<float> lightest = largestAround(image);
    const Image<float> closed = negative(largestAround(negative(lightest)));
    for (std::size_t i = 0; i < image.pixels().size(); ++i) {
        float& value = darkness.mutablePixels()[i];
        value = std::max(value, closed.pixels()[i] - image.pixels()[i]);
    }
}

// Whether lines are lighter than what they are drawn on: the picture is dark, and they lie on that side of its median.
bool hasLightLines(const Image<float>& luminance) {
    std::vector<float> values = luminance.pixels();
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    return *middle < 0.5F && mean > *middle;
}

}  // namespace

Image<float> inkOfPicture(const Image<float>& picture) {
    if (picture.empty()) return {};
    const int colors = picture.channels() < 3 ? 1 : 3;
    std::vector<Image<float>> channels;
    Image<float> luminance{picture.size(), 1};
    for (int c = 0; c < colors; ++c) {
        channels.push_back(channel(picture, c));
        for (std::size_t i = 0; i < luminance.pixels().size(); ++i)
            luminance.mutablePixels()[i] += channels.back().pixels()[i] / static_cast<float>(colors);
    }
    const bool light = hasLightLines(luminance);
    Image<float> ink{picture.size(), 1};
    for (const Image<float>& values : channels) addDarkness(light ? negative(values) : values, ink);
    std::vector<float> strong;
    for (const float value : ink.pixels())
        if (value >= faintest) strong.push_back(value);
    if (strong.empty()) return {};
    const auto nth =
        strong.begin() + static_cast<std::ptrdiff_t>(strongestShare * static_cast<double>(strong.size() - 1));
    std::nth_element(strong.begin(), nth, strong.end());
    for (float& value : ink.mutablePixels()) value = value < faintest ? 0.0F : std::min(value / *nth, 1.0F);
    return ink;
}

}  // namespace inkedge::diff
