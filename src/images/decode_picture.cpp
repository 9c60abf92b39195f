#include "images/decode_picture.h"

#include <utility>

#include <fmt/format.h>

#include "base/message.h"
#include "base/read_file.h"
#include "images/image_formats.h"
#include "images/read_png.h"

namespace inkedge::images {
namespace {

// Judges by the first bytes.
bool seemsJpeg(std::span<const std::uint8_t> picture) { return base::textOf(picture).starts_with("\xff\xd8\xff"); }
bool seemsPng(std::span<const std::uint8_t> picture) { return base::textOf(picture).starts_with("\x89PNG"); }

}  // namespace

Image<std::uint8_t> decodePicture(std::span<const std::uint8_t> picture, std::uint64_t maxPixels) {
    if (seemsJpeg(picture)) {
        DecodedPicture decoded = imageFormats(Error::Kind::Input).decodeJpeg(picture, maxPixels);
        if (!decoded.failure.empty()) base::refuse("expected a JPEG picture, found: " + base::quote(decoded.failure));
        return std::move(decoded.image);
    }
    if (!seemsPng(picture))
        base::refuse(
            fmt::format("expected a PNG or JPEG picture, found {}; convert it", base::kindOf(base::textOf(picture))));
    return readPngToLookAt(picture, maxPixels, PngChannels::Rgba);
}

std::optional<Image<std::uint8_t>> decodeOpacity(std::span<const std::uint8_t> picture, std::uint64_t maxPixels) {
    if (seemsJpeg(picture)) return {};
    if (!seemsPng(picture))
        base::refuse(fmt::format("expected a PNG or JPEG picture, found {}", base::kindOf(base::textOf(picture))));
    if (!pngHasAlpha(picture, maxPixels)) return {};
    const Image<std::uint8_t> greyAlpha = readPngToLookAt(picture, maxPixels, PngChannels::GreyAlpha);
    Image<std::uint8_t> alpha{greyAlpha.size(), 1};
    for (std::size_t i = 0; i < alpha.pixels().size(); ++i) alpha.mutablePixels()[i] = greyAlpha.pixels()[2 * i + 1];
    return alpha;
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
