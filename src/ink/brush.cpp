#include "ink/brush.h"

#include <algorithm>
#include <cmath>

#include "base/message.h"
#include "base/read_file.h"
#include "images/decode_picture.h"

namespace inkedge::ink {
namespace {

constexpr double minWidth = 1e-3;  // pixels: with a narrower pen the texture looks like its mean

// Fewer rows: each is the mean of the image's rows that it stands for.
Image<float> averagedDown(const Image<float>& image, int height) {
    Image<float> result{{image.size().width, height}, 1};
    const double step = static_cast<double>(image.size().height) / height;
    for (int y = 0; y < height; ++y) {
        const double begin = y * step;
        const double end = begin + step;
        for (int from = static_cast<int>(begin); from < image.size().height && from < end; ++from) {
            const double part = std::min(from + 1.0, end) - std::max<double>(from, begin);
            const auto share = static_cast<float>(part / step);
            for (int x = 0; x < image.size().width; ++x) result(x, y) += share * image(x, from);
        }
    }
    return result;
}

Image<float> transposed(const Image<float>& image) {
    Image<float> result{{image.size().height, image.size().width}, 1};
    for (int y = 0; y < image.size().height; ++y) {
        for (int x = 0; x < image.size().width; ++x) result(y, x) = image(x, y);
    }
    return result;
}

Image<float> unitInk(const Image<std::uint8_t>& ink) {
    Image<float> result{ink.size(), 1};
    std::ranges::transform(ink.pixels(), result.mutablePixels().begin(),
                           [](std::uint8_t v) { return static_cast<float>(v) / 255.0F; });
    return result;
}

}  // namespace

Brush readBrush(const std::filesystem::path& file, const LoadLimits& limits) {
    return base::within(file.string(), [&] {
        std::uint64_t bytesLeft = limits.fileSize;
        return Brush{images::decodeInk(base::readBytes(file, bytesLeft), limits.imagePixels)};
    });
}

FittedBrush::FittedBrush(const Brush& brush, double penWidth) : ink_{unitInk(brush.ink)} {
    const Size size = brush.ink.size();
    penWidth = std::max(penWidth, minWidth);
    const double repeat = penWidth * size.width / size.height;  // pixels along the line
    const auto fitted = [](int side, double pixels) {
        return std::max(1, static_cast<int>(std::min<double>(side, std::ceil(pixels))));
    };
    const Size needed{fitted(size.width, repeat), fitted(size.height, penWidth)};
    if (needed.height < size.height) ink_ = averagedDown(ink_, needed.height);
    if (needed.width < size.width) ink_ = transposed(averagedDown(transposed(ink_), needed.width));
    perPixel_ = static_cast<float>(needed.width / repeat);
}

float FittedBrush::stretchAround(float around) const noexcept {
    if (!(around > 0.0F)) return 1.0F;
    const float repeat = static_cast<float>(ink_.size().width) / perPixel_;
    return std::max(1.0F, std::round(around / repeat)) * repeat / around;
}

float FittedBrush::inkAt(float along, float across) const noexcept {
    const auto width = static_cast<float>(ink_.size().width);
    const auto height = static_cast<float>(ink_.size().height);
    float u = along * perPixel_ - 0.5F;
    u -= std::floor(u / width) * width;
    const float v = std::clamp((across + 0.5F) * height - 0.5F, 0.0F, height - 1.0F);
    const int x0 = std::min(static_cast<int>(u), ink_.size().width - 1);  // rounding may reach the width itself
    const int x1 = x0 + 1 < ink_.size().width ? x0 + 1 : 0;
    const int y0 = static_cast<int>(v);
    const int y1 = std::min(y0 + 1, ink_.size().height - 1);
    const float s = std::clamp(u - static_cast<float>(x0), 0.0F, 1.0F);
    const float t = v - static_cast<float>(y0);
    const auto mix = [](float a, float b, float share) { return a + (b - a) * share; };
    return mix(mix(ink_(x0, y0), ink_(x1, y0), s), mix(ink_(x0, y1), ink_(x1, y1), s), t);
}

}  // namespace inkedge::ink
