#include "passes/ink_over.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>
#include <vector>

#include "settings/picture_channels.h"

namespace inkedge::passes {
namespace {

using Channels = std::array<std::uint8_t, 4>;

// The mean of two levels, with a share of 255 for the second.
std::uint8_t mixed(int from, int to, int share) {
    return static_cast<std::uint8_t>((from * (255 - share) + to * share + 127) / 255);
}

// One picture over another, both of 4 channels.
Image<std::uint8_t> over(Image<std::uint8_t> above, const Image<std::uint8_t>& below) {
    for (std::size_t i = 0; i < above.pixels().size(); i += 4) {
        std::uint8_t* const pixel = &above.mutablePixels()[i];
        const std::uint8_t* const under = &below.pixels()[i];
        const int alpha = mixed(under[3], 255, pixel[3]);
        const int weight = alpha > 0 ? 255 * pixel[3] / alpha : 0;
        for (std::size_t c = 0; c < 3; ++c) pixel[c] = mixed(under[c], pixel[c], weight);
        pixel[3] = static_cast<std::uint8_t>(alpha);
    }
    return above;
}

Channels channelsOf(Color color, std::uint8_t alpha) { return {color.red, color.green, color.blue, alpha}; }

}  // namespace

Image<std::uint8_t> meanOf(Image<std::uint8_t> image, int samples) {
    if (samples == 1) return image;
    Image<std::uint8_t> means{{image.size().width / samples, image.size().height / samples}, 1};
    const int count = samples * samples;
    std::vector<int> sums(static_cast<std::size_t>(image.size().width));  // of columns of samples
    for (int y = 0; y < means.size().height; ++y) {
        std::ranges::fill(sums, 0);
        for (int row = samples * y; row < samples * (y + 1); ++row) {
            const std::uint8_t* const from = &image(0, row);
            for (std::size_t x = 0; x < sums.size(); ++x) sums[x] += from[x];
        }
        for (int x = 0; x < means.size().width; ++x) {
            const auto first = sums.begin() + samples * x;
            means(x, y) = static_cast<std::uint8_t>(std::accumulate(first, first + samples, count / 2) / count);
        }
    }
    return means;
}

Image<std::uint8_t> darker(Image<std::uint8_t> one, const Image<std::uint8_t>& other) {
    if (one.empty()) return other;
    for (std::size_t i = 0; i < other.pixels().size(); ++i)
        one.mutablePixels()[i] = std::max(one.pixels()[i], other.pixels()[i]);
    return one;
}

Image<std::uint8_t> maskOf(const Image<std::uint8_t>& ink, Size size) {
    Image<std::uint8_t> mask{size, 1};
    for (std::size_t i = 0; i < ink.pixels().size(); ++i) mask.mutablePixels()[i] = ink.pixels()[i] >= 128 ? 255 : 0;
    return mask;
}

void inkOver(const Image<std::uint8_t>& ink, const PictureSettings& settings, Image<std::uint8_t>& picture) {
    const Channels line = channelsOf(settings.lineColor, 255);
    const auto channels = static_cast<std::size_t>(picture.channels());
    for (std::size_t i = 0; i < ink.pixels().size(); ++i) {
        const int share = ink.pixels()[i];
        if (share == 0) continue;
        std::uint8_t* const pixel = &picture.mutablePixels()[i * channels];
        // Colours are not premultiplied: each is weighted by its part of the alpha.
        const int below = channels == 4 ? pixel[3] * (255 - share) / 255 : 255 - share;
        const int weight = share + below > 0 ? 255 * share / (share + below) : 0;
        for (std::size_t c = 0; c < std::min<std::size_t>(channels, 3); ++c)
            pixel[c] = mixed(pixel[c], line[c], weight);
        if (channels == 4) pixel[3] = mixed(pixel[3], 255, share);
    }
}

Image<std::uint8_t> onBackground(Image<std::uint8_t> drawing, const Image<std::uint8_t>& shade,
                                 const PictureSettings& settings) {
    if (!shade.empty()) drawing = over(std::move(drawing), shade);
    if (!settings.background) return drawing;
    const Channels behind = channelsOf(*settings.background, 255);
    Image<std::uint8_t> picture{drawing.size(), shade.empty() ? settings::pictureChannels(settings) : 3};
    const auto channels = static_cast<std::size_t>(picture.channels());
    for (std::size_t i = 0; i < drawing.pixels().size() / 4; ++i) {
        const std::uint8_t* const drawn = &drawing.pixels()[4 * i];
        for (std::size_t c = 0; c < channels; ++c)
            picture.mutablePixels()[i * channels + c] = mixed(behind[c], drawn[c], drawn[3]);
    }
    return picture;
}

}  // namespace inkedge::passes
