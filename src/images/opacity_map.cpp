#include "images/opacity_map.h"

#include <fmt/format.h>

#include "base/read_file.h"
#include "base/message.h"
#include "images/png_reader.h"

namespace inkedge {
namespace {

using load::refuse;

}  // namespace

std::optional<Image<std::uint8_t>> decodeOpacity(std::span<const std::uint8_t> picture, std::uint64_t mostPixels) {
    const std::string_view content = load::textOf(picture);
    if (content.starts_with("\xff\xd8\xff")) return {};  // JPEG
    if (!content.starts_with("\x89PNG"))
        refuse(fmt::format("expected a PNG or JPEG picture, found {}", load::kindOf(content)));
    load::PngReader png{picture, mostPixels};
    if (!png.hasAlpha()) return {};
    const Image<std::uint8_t> greyAlpha = png.read(PNG_FORMAT_GA);
    Image<std::uint8_t> alpha{greyAlpha.size, 1};
    for (std::size_t i = 0; i < alpha.pixels.size(); ++i) alpha.pixels[i] = greyAlpha.pixels[2 * i + 1];
    return alpha;
}

Image<std::uint8_t> decodeInk(std::span<const std::uint8_t> picture, std::uint64_t mostPixels) {
    const std::string_view content = load::textOf(picture);
    if (!content.starts_with("\x89PNG")) refuse(fmt::format("expected a PNG picture, found {}", load::kindOf(content)));
    const Image<std::uint8_t> greyAlpha = load::PngReader{picture, mostPixels}.read(PNG_FORMAT_GA);
    Image<std::uint8_t> ink{greyAlpha.size, 1};
    for (std::size_t i = 0; i < ink.pixels.size(); ++i)
        ink.pixels[i] =
            static_cast<std::uint8_t>(((255 - greyAlpha.pixels[2 * i]) * greyAlpha.pixels[2 * i + 1] + 127) / 255);
    return ink;
}

}  // namespace inkedge
