#include "scene/decode_picture.h"

#include <fmt/format.h>
#include <png.h>

#include "modules/image_module.h"
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

[[noreturn]] void refuseDamaged(const Png& png) {
    refuse("expected a PNG picture, found: " + load::quote(png.image.message));
}

}  // namespace

Image<std::uint8_t> decodePicture(std::span<const std::uint8_t> picture, std::uint64_t mostPixels) {
    const std::string_view content = load::textOf(picture);
    if (content.starts_with("\xff\xd8\xff")) {
        io::DecodedPicture decoded = io::imageFormats(Error::Kind::Input).decodeJpeg(picture, mostPixels);
        if (!decoded.failure.empty()) refuse("expected a JPEG picture, found: " + load::quote(decoded.failure));
        return std::move(decoded.image);
    }
    if (!content.starts_with("\x89PNG"))
        refuse(fmt::format("expected a PNG or JPEG picture, found {}; convert it", load::kindOf(content)));
    Png png;
    if (png_image_begin_read_from_memory(&png.image, picture.data(), picture.size()) == 0) refuseDamaged(png);
    if (std::uint64_t{png.image.width} * png.image.height > mostPixels)
        refuse(fmt::format("expected at most {} pixels, found {}x{}; raise max-image-pixels", mostPixels,
                           png.image.width, png.image.height));
    png.image.format = PNG_FORMAT_RGBA;
    Image<std::uint8_t> pixels{{static_cast<int>(png.image.width), static_cast<int>(png.image.height)}, 4};
    if (png_image_finish_read(&png.image, nullptr, pixels.pixels.data(), 0, nullptr) == 0) refuseDamaged(png);
    return pixels;
}

}  // namespace inkedge
