#include "scene/opacity_map.h"

#include <fmt/format.h>
#include <png.h>

#include "scene/load_file.h"
#include "scene/load_message.h"

namespace inkedge {
namespace {

using load::refuse;

// libpng's image, freed.
struct Png {
    png_image image{};
    Png() { image.version = PNG_IMAGE_VERSION; }
    Png(const Png&) = delete;
    Png& operator=(const Png&) = delete;
    ~Png() { png_image_free(&image); }
};

[[noreturn]] void refuseDamaged(const Png& png) { refuse("expected a PNG picture, found: " + load::quote(png.image.message)); }

void begin(Png& png, std::span<const std::uint8_t> picture, std::uint64_t mostPixels) {
    if (png_image_begin_read_from_memory(&png.image, picture.data(), picture.size()) == 0) refuseDamaged(png);
    const std::uint64_t pixels = std::uint64_t{png.image.width} * png.image.height;
    if (pixels > mostPixels)
        refuse(fmt::format("expected at most {} pixels, found {}x{}; raise max-image-pixels", mostPixels,
                           png.image.width, png.image.height));
}

// Two bytes a pixel.
std::vector<std::uint8_t> greyAlphaOf(Png& png) {
    png.image.format = PNG_FORMAT_GA;
    std::vector<std::uint8_t> greyAlpha(PNG_IMAGE_SIZE(png.image));
    if (png_image_finish_read(&png.image, nullptr, greyAlpha.data(), 0, nullptr) == 0) refuseDamaged(png);
    return greyAlpha;
}

Image<std::uint8_t> emptyLike(const Png& png) {
    return {{static_cast<int>(png.image.width), static_cast<int>(png.image.height)}, 1};
}

}  // namespace

std::optional<Image<std::uint8_t>> decodeOpacity(std::span<const std::uint8_t> picture, std::uint64_t mostPixels) {
    const std::string_view content = load::textOf(picture);
    if (content.starts_with("\xff\xd8\xff")) return {};  // JPEG
    if (!content.starts_with("\x89PNG")) refuse(fmt::format("expected a PNG or JPEG picture, found {}", load::kindOf(content)));
    Png png;
    begin(png, picture, mostPixels);
    if ((png.image.format & PNG_FORMAT_FLAG_ALPHA) == 0) return {};
    const std::vector<std::uint8_t> greyAlpha = greyAlphaOf(png);
    Image<std::uint8_t> alpha = emptyLike(png);
    for (std::size_t i = 0; i < alpha.pixels.size(); ++i) alpha.pixels[i] = greyAlpha[2 * i + 1];
    return alpha;
}

Image<std::uint8_t> decodeInk(std::span<const std::uint8_t> picture, std::uint64_t mostPixels) {
    const std::string_view content = load::textOf(picture);
    if (!content.starts_with("\x89PNG")) refuse(fmt::format("expected a PNG picture, found {}", load::kindOf(content)));
    Png png;
    begin(png, picture, mostPixels);
    const std::vector<std::uint8_t> greyAlpha = greyAlphaOf(png);
    Image<std::uint8_t> ink = emptyLike(png);
    for (std::size_t i = 0; i < ink.pixels.size(); ++i)
        ink.pixels[i] = static_cast<std::uint8_t>(((255 - greyAlpha[2 * i]) * greyAlpha[2 * i + 1] + 127) / 255);
    return ink;
}

}  // namespace inkedge
