#include "io/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include <inkedge/error.h>
#include <inkedge/write.h>

#include "base/staged_files.h"
#include "images/image_formats.h"
#include "io/output_formats.h"

namespace inkedge::io {
namespace {

/// IEC 61966-2-1, equation 7.
float linearLight(std::uint8_t value) {
    const double encoded = value / 255.0;
    return static_cast<float>(encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4));
}

const std::array<float, 256>& linearLights() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> values{};
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = linearLight(static_cast<std::uint8_t>(i));
        return values;
    }();
    return table;
}

std::vector<std::uint8_t> encodeWithModule(images::FileFormat format, const images::Layer& layer,
                                           const std::filesystem::path& target) {
    images::EncodedPicture encoded = images::imageFormats(Error::Kind::Output).encode(format, {&layer, 1}, {});
    if (!encoded.failure.empty()) base::failToWrite(target, encoded.failure);
    return std::move(encoded.bytes);
}

}  // namespace

std::vector<std::uint8_t> encodePicture(const Image<std::uint8_t>& picture, const std::filesystem::path& target) {
    switch (pictureFormat(target)) {
        case PictureFormat::Png:
            break;
        case PictureFormat::Tiff:
            return encodeWithModule(images::FileFormat::Tiff,
                                    {&picture, channelNames(picture.channels()), images::SampleType::Uint8}, target);
        case PictureFormat::OpenExr: {
            const Image<float> linear = linearPicture(picture);
            return encodeWithModule(images::FileFormat::OpenExr,
                                    {&linear, channelNames(linear.channels()), images::SampleType::Half}, target);
        }
    }
    return encodePng(picture);
}

Image<float> linearPicture(const Image<std::uint8_t>& picture) {
    const std::array<float, 256>& lights = linearLights();
    const bool grey = picture.channels() == 1;
    Image<float> linear{picture.size(), grey ? 3 : picture.channels()};
    for (int y = 0; y < picture.size().height; ++y) {
        for (int x = 0; x < picture.size().width; ++x) {
            const float alpha = picture.channels() == 4 ? static_cast<float>(picture(x, y, 3)) / 255.0F : 1.0F;
            for (int c = 0; c < 3; ++c) linear(x, y, c) = alpha * lights[picture(x, y, grey ? 0 : c)];
            if (picture.channels() == 4) linear(x, y, 3) = alpha;
        }
    }
    return linear;
}

std::vector<std::string> channelNames(int channels) {
    if (channels == 1) return {"Y"};
    if (channels == 3) return {"R", "G", "B"};
    return {"R", "G", "B", "A"};
}

}  // namespace inkedge::io
