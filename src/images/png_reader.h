#pragma once

#include <cstdint>
#include <span>

#include <fmt/format.h>
#include <png.h>

#include <inkedge/image.h>

#include "base/message.h"

namespace inkedge::load {

/// A PNG picture in memory, begun to be read: its size and format are known. Frees libpng's image.
class PngReader {
public:
    /// @throws Error  (Kind::Input) if it is damaged or has over mostPixels
    PngReader(std::span<const std::uint8_t> picture, std::uint64_t mostPixels) : PngReader{} {
        if (png_image_begin_read_from_memory(&image_, picture.data(), picture.size()) == 0) refuseDamaged();
        if (std::uint64_t{image_.width} * image_.height > mostPixels) {
            refuse(fmt::format("expected at most {} pixels, found {}x{}; raise max-image-pixels", mostPixels,
                               image_.width, image_.height));
        }
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_image_free(&image_); }

    [[nodiscard]] bool hasAlpha() const noexcept { return (image_.format & PNG_FORMAT_FLAG_ALPHA) != 0; }
    [[nodiscard]] Size size() const noexcept {
        return {static_cast<int>(image_.width), static_cast<int>(image_.height)};
    }

    /// @param format  of libpng, 8 bits a channel: PNG_FORMAT_GA, PNG_FORMAT_RGBA
    /// @throws Error  (Kind::Input) if it is damaged
    [[nodiscard]] Image<std::uint8_t> read(png_uint_32 format) {
        image_.format = format;
        Image<std::uint8_t> pixels{size(), static_cast<int>(PNG_IMAGE_PIXEL_CHANNELS(format))};
        if (png_image_finish_read(&image_, nullptr, pixels.pixels.data(), 0, nullptr) == 0) refuseDamaged();
        return pixels;
    }

private:
    // What comes after it in another constructor may throw: the destructor runs even then.
    PngReader() noexcept { image_.version = PNG_IMAGE_VERSION; }

    [[noreturn]] void refuseDamaged() const { refuse("expected a PNG picture, found: " + quote(image_.message)); }

    png_image image_{};
};

}  // namespace inkedge::load
