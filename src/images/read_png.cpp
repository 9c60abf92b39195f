#include "images/read_png.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <new>
#include <string>
#include <vector>

#include "base/message.h"

namespace inkedge::images {
namespace {

constexpr std::size_t signatureSize = 8;

/// Owns the two structures of libpng that read, and the bytes that they read from. Where a step returns false,
/// `failure` says why.
struct Decoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::span<const std::uint8_t> whole;
    std::span<const std::uint8_t> rest;
    std::string failure;

    explicit Decoder(std::span<const std::uint8_t> bytes);
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }

    [[nodiscard]] std::size_t width() const { return png_get_image_width(png, info); }
    [[nodiscard]] std::size_t height() const { return png_get_image_height(png, info); }
    [[nodiscard]] Size size() const { return {static_cast<int>(width()), static_cast<int>(height())}; }
    [[nodiscard]] bool hasColor() const { return (png_get_color_type(png, info) & PNG_COLOR_MASK_COLOR) != 0; }
    [[nodiscard]] bool hasAlpha() const {
        return (png_get_color_type(png, info) & PNG_COLOR_MASK_ALPHA) != 0 ||
               png_get_valid(png, info, PNG_INFO_tRNS) != 0;
    }
};

// libpng handles an error by longjmp; no object with a destructor may live in the frames that it jumps over.
[[noreturn]] void leave(png_structp png, png_const_charp message) {
    static_cast<Decoder*>(png_get_error_ptr(png))->failure = message;
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

void take(png_structp png, png_bytep data, png_size_t size) {
    auto& rest = static_cast<Decoder*>(png_get_io_ptr(png))->rest;
    if (size > rest.size()) png_error(png, "its end too early");
    std::memcpy(data, rest.data(), size);
    rest = rest.subspan(size);
}

Decoder::Decoder(std::span<const std::uint8_t> bytes) : whole{bytes}, rest{bytes} {
    png = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, leave, ignoreWarning);
    if (png != nullptr) info = png_create_info_struct(png);
    if (info == nullptr) {
        png_destroy_read_struct(&png, nullptr, nullptr);
        throw std::bad_alloc{};
    }
}

/// Reads what comes before the pixels.
bool readHeader(Decoder& decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    png_set_read_fn(decoder.png, &decoder, take);
    png_read_info(decoder.png, decoder.info);
    return true;
}

/// Asks for 8 or 16 bits a channel, as in the file, in the byte order of this machine.
bool askForValues(Decoder& decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    png_set_expand(decoder.png);
    if (std::endian::native == std::endian::little) png_set_swap(decoder.png);
    png_set_interlace_handling(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
    return true;
}

/// Asks for 8 bits in sRGB. A file without a gamma of its own is taken for linear if it has 16 bits, else for sRGB, as
/// libpng's own simplified reading does.
bool askForLooks(Decoder& decoder, PngChannels channels) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    constexpr int silently = 1;
    const bool deep = png_get_bit_depth(decoder.png, decoder.info) == 16;
    png_set_expand(decoder.png);
    if (channels == PngChannels::Rgba && !decoder.hasColor()) png_set_gray_to_rgb(decoder.png);
    if (channels == PngChannels::GreyAlpha && decoder.hasColor())
        png_set_rgb_to_gray_fixed(decoder.png, silently, PNG_RGB_TO_GRAY_DEFAULT, PNG_RGB_TO_GRAY_DEFAULT);
    png_set_alpha_mode_fixed(decoder.png, PNG_ALPHA_PNG, deep ? PNG_GAMMA_LINEAR : PNG_DEFAULT_sRGB);
    if (deep) png_set_scale_16(decoder.png);
    if (!decoder.hasAlpha()) png_set_add_alpha(decoder.png, 255, PNG_FILLER_AFTER);
    png_set_alpha_mode_fixed(decoder.png, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);
    png_set_interlace_handling(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
    return true;
}

bool readRows(Decoder& decoder, png_bytepp rows) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    png_read_image(decoder.png, rows);
    return true;
}

bool readEnd(Decoder& decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    png_read_end(decoder.png, nullptr);
    return true;
}

// Whether the bytes can hold the rows of the picture: a few bytes must not make us allocate memory for a large picture.
bool canHoldItsRows(Decoder& decoder) {
    constexpr std::size_t highestRatio = 1100;  // deflate: 1032
    const std::size_t maxRowBytes = highestRatio * decoder.whole.size() / std::max<std::size_t>(decoder.height(), 1);
    if (png_get_rowbytes(decoder.png, decoder.info) <= maxRowBytes) return true;
    decoder.failure = "fewer bytes than its pixels need";
    return false;
}

// Reads the last chunk. libpng 1.6.48 does not check the checksum of that chunk any more; 1.6.39 does.
bool endsWhole(Decoder& decoder) {
    constexpr std::array<std::uint8_t, 12> end{0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
    const auto read = decoder.whole.first(decoder.whole.size() - decoder.rest.size());
    if (read.size() >= end.size() && std::ranges::equal(read.last(end.size()), end)) return true;
    decoder.failure = "a wrong last chunk";
    return false;
}

/// Reads all rows, one after the other.
bool readPixels(Decoder& decoder, std::span<std::uint8_t> to) {
    const std::size_t rowSize = png_get_rowbytes(decoder.png, decoder.info);
    std::vector<png_bytep> rows;
    for (std::size_t y = 0; y < decoder.height(); ++y) rows.push_back(&to[rowSize * y]);
    return readRows(decoder, rows.data());
}

template <class Sample>
void scale(const std::vector<std::uint8_t>& bytes, float largest, std::span<float> pixels) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        Sample sample{};
        std::memcpy(&sample, bytes.data() + i * sizeof sample, sizeof sample);
        pixels[i] = static_cast<float>(sample) / largest;
    }
}

[[noreturn]] void refuseDamaged(const Decoder& decoder) {
    base::refuse("expected a PNG picture, found: " + base::quote(decoder.failure));
}

void beginToLook(Decoder& decoder, std::uint64_t maxPixels) {
    if (!readHeader(decoder)) refuseDamaged(decoder);
    if (std::uint64_t{decoder.width()} * decoder.height() > maxPixels)
        base::refuse(fmt::format("expected at most {} pixels, found {}x{}; raise max-image-pixels", maxPixels,
                                 decoder.width(), decoder.height()));
}

}  // namespace

bool isPng(std::span<const std::uint8_t> bytes) noexcept {
    return bytes.size() >= signatureSize && png_sig_cmp(bytes.data(), 0, signatureSize) == 0;
}

ReadPicture readPng(std::span<const std::uint8_t> bytes) {
    Decoder decoder{bytes};
    const auto failed = [&] {
        return ReadPicture{{}, true, fmt::format("expected a whole PNG, found {}; write it again", decoder.failure)};
    };
    if (!readHeader(decoder) || !canHoldItsRows(decoder) || !askForValues(decoder)) return failed();
    std::vector<std::uint8_t> samples(png_get_rowbytes(decoder.png, decoder.info) * decoder.height());
    if (!readPixels(decoder, samples) || !readEnd(decoder) || !endsWhole(decoder)) return failed();
    ReadPicture result{{decoder.size(), png_get_channels(decoder.png, decoder.info)}, true, {}};
    if (png_get_bit_depth(decoder.png, decoder.info) == 16) {
        scale<std::uint16_t>(samples, 65535.0F, result.image.mutablePixels());
    } else {
        scale<std::uint8_t>(samples, 255.0F, result.image.mutablePixels());
    }
    return result;
}

Image<std::uint8_t> readPngToLookAt(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels,
                                    PngChannels channels) {
    Decoder decoder{bytes};
    beginToLook(decoder, maxPixels);
    if (!canHoldItsRows(decoder) || !askForLooks(decoder, channels)) refuseDamaged(decoder);
    Image<std::uint8_t> image{decoder.size(), channels == PngChannels::Rgba ? 4 : 2};
    if (!readPixels(decoder, image.mutablePixels())) refuseDamaged(decoder);
    return image;
}

bool pngHasAlpha(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels) {
    Decoder decoder{bytes};
    beginToLook(decoder, maxPixels);
    return decoder.hasAlpha();
}

}  // namespace inkedge::images
