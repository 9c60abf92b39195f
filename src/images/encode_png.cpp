#include <fmt/format.h>
#include <png.h>
#include <zlib.h>

#include <bit>
#include <cmath>
#include <csetjmp>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

#include <inkedge/encode_png.h>
#include <inkedge/error.h>

namespace inkedge {
namespace {

/// Owns the two structures of libpng that write, and the bytes that they produce.
struct Encoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::vector<std::uint8_t> bytes;
    std::string failure;

    Encoder() = default;
    Encoder(const Encoder&) = delete;
    Encoder& operator=(const Encoder&) = delete;
    ~Encoder() { png_destroy_write_struct(&png, &info); }
};

// libpng handles an error by longjmp; no object with a destructor may live in the frames that it jumps over.
[[noreturn]] void leave(png_structp png, png_const_charp message) {
    static_cast<Encoder*>(png_get_error_ptr(png))->failure = message;
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

void append(png_structp png, png_bytep data, png_size_t size) {
    bool stored = false;
    try {
        auto& bytes = static_cast<Encoder*>(png_get_io_ptr(png))->bytes;
        bytes.insert(bytes.end(), data, data + size);
        stored = true;
    } catch (const std::exception&) {
    }
    if (!stored) png_error(png, "out of memory");
}

void flush(png_structp) {}

int colorType(int channels) {
    switch (channels) {
        case 1:
            return PNG_COLOR_TYPE_GRAY;
        case 3:
            return PNG_COLOR_TYPE_RGB;
        case 4:
            return PNG_COLOR_TYPE_RGB_ALPHA;
        default:
            throw Error{Error::Kind::Usage,
                        fmt::format("PNG: expected a picture of 1, 3 or 4 channels, found {}", channels)};
    }
}

/// A picture of few colours: one byte a pixel.
struct Palette {
    std::vector<png_color> colors;
    std::vector<png_byte> opacities;  // of four channels; else empty
    Image<std::uint8_t> indices;
};

std::uint32_t packed(const std::uint8_t* pixel, int channels) {
    std::uint32_t value = 0;
    for (int k = 0; k < channels; ++k) value |= std::uint32_t{pixel[k]} << (8 * k);
    return value;
}

/// The palette of a picture of at most 256 colours, as pictures of lines of one colour have; none if the picture has
/// more, or is so small that the palette's own bytes are not worth it.
std::optional<Palette> paletteOf(const Image<std::uint8_t>& image) {
    constexpr std::size_t maxColors = 256;
    constexpr std::size_t worthIt = 16 * maxColors;  // pixels
    const auto channels = static_cast<std::size_t>(image.channels());
    const std::size_t pixels = image.pixels().size() / channels;
    if (channels == 1 || pixels < worthIt) return {};
    Palette palette{{}, {}, {image.size(), 1}};
    std::unordered_map<std::uint32_t, std::uint8_t> known;
    std::optional<std::uint32_t> last;
    std::uint8_t index = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const std::uint8_t* const pixel = &image.pixels()[i * channels];
        if (const std::uint32_t color = packed(pixel, image.channels()); color != last) {
            const auto [found, added] = known.try_emplace(color, static_cast<std::uint8_t>(known.size()));
            if (known.size() > maxColors) return {};
            if (added) palette.colors.push_back({pixel[0], pixel[1], pixel[2]});
            if (added && channels == 4) palette.opacities.push_back(pixel[3]);
            index = found->second;
            last = color;
        }
        palette.indices.mutablePixels()[i] = index;
    }
    return palette;
}

/// Of the quick compressions, the one that gives small files for line pictures (1024 x 1024, 8-bit grey: 2.5 ms and
/// 25 kB; libpng's own choice takes 12 ms and 27 kB) and not too large ones for smooth pictures of depths and normals.
/// Samples of 16 bits repeat themselves at a distance: depths take half the bytes and no more time with strings of any.
void chooseQuickCompression(png_structp png, std::size_t bytesPerSample) {
    png_set_compression_level(png, 1);
    png_set_compression_strategy(png, bytesPerSample == 1 ? Z_RLE : Z_DEFAULT_STRATEGY);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_UP);
}

/// Writes samples of 8 bits, or of 16 in the byte order of this machine.
/// @return whether libpng finished; if not, encoder.failure says why
/// @param palette         of the picture, whose indices the image then holds; or null
/// @param pixelsPerMetre  0: the file does not tell
template <class Sample>
bool encode(Encoder& encoder, const Image<Sample>& image, const Palette* palette, png_uint_32 pixelsPerMetre) {
    if (setjmp(png_jmpbuf(encoder.png)) != 0) return false;
    // The picture was drawn within our own limits; libpng's limits, made for files from elsewhere, are off.
    png_set_user_limits(encoder.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_set_write_fn(encoder.png, &encoder, append, flush);
    chooseQuickCompression(encoder.png, sizeof(Sample));
    png_set_IHDR(encoder.png, encoder.info, static_cast<png_uint_32>(image.size().width),
                 static_cast<png_uint_32>(image.size().height), 8 * static_cast<int>(sizeof(Sample)),
                 palette != nullptr ? PNG_COLOR_TYPE_PALETTE : colorType(image.channels()), PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (palette != nullptr) {
        png_set_PLTE(encoder.png, encoder.info, palette->colors.data(), static_cast<int>(palette->colors.size()));
        if (!palette->opacities.empty()) {
            png_set_tRNS(encoder.png, encoder.info, palette->opacities.data(),
                         static_cast<int>(palette->opacities.size()), nullptr);
        }
    }
    if (pixelsPerMetre > 0)
        png_set_pHYs(encoder.png, encoder.info, pixelsPerMetre, pixelsPerMetre, PNG_RESOLUTION_METER);
    png_write_info(encoder.png, encoder.info);
    if (sizeof(Sample) == 2 && std::endian::native == std::endian::little) png_set_swap(encoder.png);
    for (int y = 0; y < image.size().height; ++y)
        png_write_row(encoder.png, reinterpret_cast<png_const_bytep>(&image.at(0, y)));
    png_write_end(encoder.png, encoder.info);
    return true;
}

template <class Sample>
void expectEncodable(const Image<Sample>& image) {
    static_cast<void>(colorType(image.channels()));
    if (image.empty()) throw Error{Error::Kind::Usage, "PNG: expected a picture of at least one pixel, found none"};
}

// @return 0 if none is given, or one that a file cannot tell
png_uint_32 pixelsPerMetre(std::optional<double> dpi) {
    constexpr double metresPerInch = 0.0254;
    const double pixels = std::round(dpi.value_or(0.0) / metresPerInch);
    return pixels >= 1.0 && pixels <= PNG_UINT_31_MAX ? static_cast<png_uint_32>(pixels) : 0;
}

template <class Sample>
std::vector<std::uint8_t> encoded(const Image<Sample>& image, const Palette* palette, std::optional<double> dpi) {
    Encoder encoder;
    encoder.png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &encoder, leave, ignoreWarning);
    if (encoder.png != nullptr) encoder.info = png_create_info_struct(encoder.png);
    if (encoder.info == nullptr) throw std::bad_alloc{};
    if (!encode(encoder, image, palette, pixelsPerMetre(dpi))) {
        throw Error{Error::Kind::Runtime, fmt::format("PNG: a picture of {} x {} cannot be encoded: {}",
                                                      image.size().width, image.size().height, encoder.failure)};
    }
    return std::move(encoder.bytes);
}

}  // namespace

std::vector<std::uint8_t> encodePng(const Image<std::uint8_t>& image, std::optional<double> dpi) {
    expectEncodable(image);
    const std::optional<Palette> palette = paletteOf(image);
    return palette ? encoded(palette->indices, &*palette, dpi) : encoded(image, nullptr, dpi);
}

std::vector<std::uint8_t> encodePng(const Image<std::uint16_t>& image, std::optional<double> dpi) {
    expectEncodable(image);
    return encoded(image, nullptr, dpi);
}

}  // namespace inkedge
