#include "io/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <inkedge/error.h>
#include <inkedge/write.h>

#include "base/staged_files.h"
#include "images/encode_exr.h"
#include "images/image_formats.h"
#include "io/npz.h"
#include "io/output_formats.h"

namespace inkedge::io {
namespace {

/// IEC 61966-2-1, equation 7.
float linearLight(std::uint8_t value) {
    const double encoded = value / 255.0;
    return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

/// To the nearest value that 16 bits hold: finer by far than 8 bits of sRGB, and half the size when compressed.
float toHalf(float value) {
    constexpr int digits = 11;
    constexpr int minExponent = -13;  // below it the steps stay the same
    int exponent = 0;
    std::frexp(value, &exponent);
    const float step = std::ldexp(1.0F, std::max(exponent, minExponent) - digits);
    return std::nearbyint(value / step) * step;
}

struct Light {
    float exact;
    float asHalf;
};

const std::array<Light, 256>& linearLights() {
    static const std::array<Light, 256> table = [] {
        std::array<Light, 256> lights{};
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const float light = linearLight(static_cast<std::uint8_t>(i));
            lights[i] = {light, toHalf(light)};
        }
        return lights;
    }();
    return table;
}

}  // namespace

std::vector<std::uint8_t> encodePicture(const Image<std::uint8_t>& picture, const std::filesystem::path& target,
                                        std::optional<double> dpi) {
    switch (pictureFormat(target)) {
        case PictureFormat::Png:
            break;
        case PictureFormat::Tiff:
            return encodeTiff({&picture, channelNames(picture.channels())}, images::SampleType::Uint8, dpi, target);
        case PictureFormat::OpenExr: {
            const Image<float> linear = linearPicture(picture);
            const images::Layer layer{&linear, channelNames(linear.channels())};
            return images::encodeExr({&layer, 1}, {});
        }
        case PictureFormat::Npz: {
            NpzWriter arrays;
            arrays.add("picture", picture);
            return std::move(arrays).take();
        }
    }
    return encodePng(picture, dpi);
}

std::vector<std::uint8_t> encodeTiff(const images::Layer& layer, images::SampleType type, std::optional<double> dpi,
                                     const std::filesystem::path& target) {
    images::EncodedPicture encoded = images::imageFormats(Error::Kind::Output).encodeTiff(layer, type, dpi);
    if (!encoded.failure.empty()) base::failToWrite(target, encoded.failure);
    return std::move(encoded.bytes);
}

Image<float> linearPicture(const Image<std::uint8_t>& picture) {
    const std::array<Light, 256>& lights = linearLights();
    const auto channels = static_cast<std::size_t>(picture.channels());
    const std::size_t last = channels == 1 ? 0 : 2;  // grey serves for all three
    Image<float> linear{picture.size(), channels == 4 ? 4 : 3};
    float* to = linear.mutablePixels().data();
    for (std::size_t i = 0; i < picture.pixels().size(); i += channels) {
        const std::uint8_t* const from = &picture.pixels()[i];
        const std::uint8_t opacity = channels == 4 ? from[3] : 255;
        const float alpha = static_cast<float>(opacity) / 255.0F;
        for (std::size_t c = 0; c < 3; ++c) {
            const Light& light = lights[from[std::min(c, last)]];
            *to++ = opacity == 255 ? light.asHalf : toHalf(alpha * light.exact);
        }
        if (channels == 4) *to++ = toHalf(alpha);
    }
    return linear;
}

std::vector<std::string> channelNames(int channels) {
    if (channels == 1) return {"Y"};
    if (channels == 3) return {"R", "G", "B"};
    return {"R", "G", "B", "A"};
}

}  // namespace inkedge::io
