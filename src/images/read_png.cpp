#include "images/read_png.h"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <bit>
#include <csetjmp>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

namespace inkedge::io {
namespace {

constexpr std::size_t signatureSize = 8;

/// Owns libpng's two reading structures and what they read from.
struct Decoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::span<const std::uint8_t> rest;
    std::string failure;

    Decoder() = default;
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

// libpng leaves an error by longjmp; no object with a destructor may live in the frames that it jumps over.
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

/// Reads what stands before the pixels. @return whether libpng finished; if not, decoder.failure says why
bool readHeader(Decoder& decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    png_set_read_fn(decoder.png, &decoder, take);
    png_read_info(decoder.png, decoder.info);
    return true;
}

/// Asks for 8 or 16 bits a channel in the byte order of this machine. @return likewise
bool prepareRows(Decoder& decoder) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    png_set_expand(decoder.png);
    if (std::endian::native == std::endian::little) png_set_swap(decoder.png);
    png_set_interlace_handling(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
    return true;
}

/// @return likewise
bool readRows(Decoder& decoder, std::vector<png_bytep>& rows) {
    if (setjmp(png_jmpbuf(decoder.png)) != 0) return false;
    png_read_image(decoder.png, rows.data());
    png_read_end(decoder.png, nullptr);
    return true;
}

// A few bytes must not make us ask for the memory of a picture that they cannot hold.
bool canHoldItsRows(const Decoder& decoder, std::size_t fileSize) {
    constexpr std::size_t highestRatio = 1100;  // deflate: 1032
    const std::size_t height = png_get_image_height(decoder.png, decoder.info);
    return png_get_rowbytes(decoder.png, decoder.info) <= highestRatio * fileSize / std::max<std::size_t>(height, 1);
}

// libpng 1.6.48 no longer looks at the last chunk's checksum, which 1.6.39 does.
bool endsWhole(std::span<const std::uint8_t> bytes, std::span<const std::uint8_t> rest) {
    constexpr std::array<std::uint8_t, 12> end{0, 0, 0, 0, 'I', 'E', 'N', 'D', 0xae, 0x42, 0x60, 0x82};
    bytes = bytes.first(bytes.size() - rest.size());
    return bytes.size() >= end.size() && std::ranges::equal(bytes.last(end.size()), end);
}

template <class Sample>
void scale(const std::vector<std::uint8_t>& bytes, float largest, std::vector<float>& pixels) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        Sample sample{};
        std::memcpy(&sample, bytes.data() + i * sizeof sample, sizeof sample);
        pixels[i] = static_cast<float>(sample) / largest;
    }
}

ReadPicture failed(const std::string& found) {
    return {{}, true, fmt::format("expected a whole PNG, found {}; write it again", found)};
}

}  // namespace

bool isPng(std::span<const std::uint8_t> bytes) noexcept {
    return bytes.size() >= signatureSize && png_sig_cmp(bytes.data(), 0, signatureSize) == 0;
}

ReadPicture readPng(std::span<const std::uint8_t> bytes) {
    Decoder decoder;
    decoder.rest = bytes;
    decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, leave, ignoreWarning);
    if (decoder.png != nullptr) decoder.info = png_create_info_struct(decoder.png);
    if (decoder.info == nullptr) throw std::bad_alloc{};
    if (!readHeader(decoder)) return failed(decoder.failure);
    if (!canHoldItsRows(decoder, bytes.size())) return failed("fewer bytes than its pixels need");
    if (!prepareRows(decoder)) return failed(decoder.failure);

    const auto width = static_cast<int>(png_get_image_width(decoder.png, decoder.info));
    const auto height = static_cast<int>(png_get_image_height(decoder.png, decoder.info));
    const std::size_t rowSize = png_get_rowbytes(decoder.png, decoder.info);
    std::vector<std::uint8_t> samples(rowSize * static_cast<std::size_t>(height));
    std::vector<png_bytep> rows;
    for (int y = 0; y < height; ++y) rows.push_back(samples.data() + rowSize * static_cast<std::size_t>(y));
    if (!readRows(decoder, rows)) return failed(decoder.failure);
    if (!endsWhole(bytes, decoder.rest)) return failed("a wrong last chunk");

    ReadPicture result{{{width, height}, png_get_channels(decoder.png, decoder.info)}, true, {}};
    if (png_get_bit_depth(decoder.png, decoder.info) == 16) {
        scale<std::uint16_t>(samples, 65535.0F, result.image.pixels);
    } else {
        scale<std::uint8_t>(samples, 255.0F, result.image.pixels);
    }
    return result;
}

}  // namespace inkedge::io
