#include "images/decode_picture.h"

#include <utility>

#include <fmt/format.h>

#include "base/message.h"
#include "base/read_file.h"
#include "images/image_formats.h"
#include "images/read_png.h"
#include "images/read_webp.h"

namespace inkedge::images {
namespace {

// Judges by the first bytes.
bool seemsJpeg(std::span<const std::uint8_t> picture) { return base::textOf(picture).starts_with("\xff\xd8\xff"); }
bool seemsPng(std::span<const std::uint8_t> picture) { return base::textOf(picture).starts_with("\x89PNG"); }

[[noreturn]] void refuseForm(std::span<const std::uint8_t> picture) {
    base::refuse(
        fmt::format("expected a PNG, JPEG or WebP picture, found {}; convert it", base::kindOf(base::textOf(picture))));
}

Image<std::uint8_t> lastChannel(const Image<std::uint8_t>& picture) {
    Image<std::uint8_t> last{picture.size(), 1};
    const auto channels = static_cast<std::size_t>(picture.channels());
    for (std::size_t i = 0; i < last.pixels().size(); ++i)
        last.mutablePixels()[i] = picture.pixels()[channels * (i + 1) - 1];
    return last;
}

}  // namespace

Image<std::uint8_t> decodePicture(std::span<const std::uint8_t> picture, std::uint64_t maxPixels) {
    if (seemsJpeg(picture)) {
        DecodedPicture decoded = imageFormats(Error::Kind::Input).decodeJpeg(picture, maxPixels);
        if (!decoded.failure.empty()) base::refuse("expected a JPEG picture, found: " + base::quote(decoded.failure));
        return std::move(decoded.image);
    }
    if (isWebp(picture)) return readWebp(picture, maxPixels);
    if (!seemsPng(picture)) refuseForm(picture);
    return readPngToLookAt(picture, maxPixels, PngChannels::Rgba);
}

std::optional<Image<std::uint8_t>> decodeOpacity(std::span<const std::uint8_t> picture, std::uint64_t maxPixels) {
    if (seemsJpeg(picture)) return {};
    if (isWebp(picture)) {
        if (!webpHasAlpha(picture, maxPixels)) return {};
        return lastChannel(readWebp(picture, maxPixels));
    }
    if (!seemsPng(picture)) refuseForm(picture);
    if (!pngHasAlpha(picture, maxPixels)) return {};
    return lastChannel(readPngToLookAt(picture, maxPixels, PngChannels::GreyAlpha));
}

Image<std::uint8_t> decodeInk(std::span<const std::uint8_t> picture, std::uint64_t maxPixels) {
    if (!seemsPng(picture))
        base::refuse(fmt::format("expected a PNG picture, found {}", base::kindOf(base::textOf(picture))));
    const Image<std::uint8_t> greyAlpha = readPngToLookAt(picture, maxPixels, PngChannels::GreyAlpha);
    Image<std::uint8_t> ink{greyAlpha.size(), 1};
    for (std::size_t i = 0; i < ink.pixels().size(); ++i)
        ink.mutablePixels()[i] =
            static_cast<std::uint8_t>(((255 - greyAlpha.pixels()[2 * i]) * greyAlpha.pixels()[2 * i + 1] + 127) / 255);
    return ink;
}

}  // namespace inkedge::images
