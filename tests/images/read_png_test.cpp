#include "images/read_png.h"

#include <csetjmp>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <png.h>

#include <inkedge/error.h>

namespace inkedge {
namespace {

using images::PngChannels;
using Bytes = std::vector<std::uint8_t>;

constexpr png_uint_32 width = 19;
constexpr png_uint_32 height = 11;

struct Kind {
    int color;
    int depth;
    bool transparent;  // a tRNS chunk
    int gamma;         // of a gAMA chunk, in 1/100,000; 0: none, -1: an sRGB chunk
    int interlace;
};

void PrintTo(const Kind& k, std::ostream* out) {
    *out << "colour type " << k.color << ", " << k.depth << " bits, tRNS " << k.transparent << ", gamma " << k.gamma
         << ", interlace " << k.interlace;
}

void append(png_structp png, png_bytep data, png_size_t size) {
    auto& bytes = *static_cast<Bytes*>(png_get_io_ptr(png));
    bytes.insert(bytes.end(), data, data + size);
}

// Noise in every pixel.
Bytes written(const Kind& kind) {
    Bytes bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, nullptr);
    png_set_IHDR(png, info, width, height, kind.depth, kind.color, kind.interlace, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    std::mt19937 random{7};
    const auto byte = [&] { return static_cast<png_byte>(random() & 255U); };
    if (kind.color == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> palette(std::size_t{1} << static_cast<unsigned>(kind.depth));
        for (png_color& color : palette) color = {byte(), byte(), byte()};
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    if (kind.transparent) {
        const png_byte opacities[2]{0, 100};
        const png_color_16 color{0, 1, 2, 3, 1};
        png_set_tRNS(png, info, opacities, 2, &color);
    }
    if (kind.gamma > 0) png_set_gAMA_fixed(png, info, kind.gamma);
    if (kind.gamma < 0) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    std::vector<Bytes> rows(height, Bytes(png_get_rowbytes(png, info)));
    std::vector<png_bytep> starts;
    for (Bytes& row : rows) {
        for (std::uint8_t& b : row) b = byte();
        starts.push_back(row.data());
    }
    png_write_image(png, starts.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

std::vector<Kind> kinds() {
    std::vector<Kind> all;
    for (const int gamma : {0, -1, 45455, 100000})
        for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7})
            for (const bool transparent : {false, true}) {
                for (const int depth : {1, 2, 4, 8, 16})
                    all.push_back({PNG_COLOR_TYPE_GRAY, depth, transparent, gamma, interlace});
                for (const int depth : {1, 2, 4, 8})
                    all.push_back({PNG_COLOR_TYPE_PALETTE, depth, transparent, gamma, interlace});
                for (const int depth : {8, 16}) {
                    all.push_back({PNG_COLOR_TYPE_RGB, depth, transparent, gamma, interlace});
                    if (transparent) continue;
                    all.push_back({PNG_COLOR_TYPE_GRAY_ALPHA, depth, false, gamma, interlace});
                    all.push_back({PNG_COLOR_TYPE_RGB_ALPHA, depth, false, gamma, interlace});
                }
            }
    return all;
}

// What libpng's simplified reading makes of it.
Bytes simplified(const Bytes& file, png_uint_32 format, bool& hasAlpha) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, file.data(), file.size()), 0) << image.message;
    hasAlpha = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
    image.format = format;
    Bytes pixels(PNG_IMAGE_SIZE(image));
    EXPECT_NE(png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr), 0) << image.message;
    return pixels;
}

TEST(ReadPngToLookAt, isLibpngsSimplifiedReading) {
    for (const Kind& kind : kinds()) {
        const Bytes file = written(kind);
        Kind plain = kind;
        plain.interlace = PNG_INTERLACE_NONE;  // of 16 bits, interlaced, it mixes pixels up (1.6.39)
        const Bytes plainFile = written(plain);
        bool hasAlpha = false;
        const Bytes rgba = simplified(plainFile, PNG_FORMAT_RGBA, hasAlpha);
        EXPECT_EQ(images::readPngToLookAt(file, 1000, PngChannels::Rgba).pixels(), rgba)
            << testing::PrintToString(kind);
        const Bytes greyAlpha = simplified(plainFile, PNG_FORMAT_GA, hasAlpha);
        EXPECT_EQ(images::readPngToLookAt(file, 1000, PngChannels::GreyAlpha).pixels(), greyAlpha)
            << testing::PrintToString(kind);
        EXPECT_EQ(images::pngHasAlpha(file, 1000), hasAlpha) << testing::PrintToString(kind);
    }
}

TEST(ReadPngToLookAt, refusesWhatIsCutOrTooLarge) {
    const Bytes file = written({PNG_COLOR_TYPE_RGB, 8, false, 0, PNG_INTERLACE_NONE});
    const auto refusal = [](const Bytes& bytes, std::uint64_t maxPixels) -> std::string {
        try {
            static_cast<void>(images::readPngToLookAt(bytes, maxPixels, PngChannels::Rgba));
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), Error::Kind::Input);
            return error.what();
        }
        return {};
    };
    EXPECT_EQ(refusal(file, width * height), "");
    EXPECT_EQ(refusal(file, width * height - 1), "expected at most 208 pixels, found 19x11; raise max-image-pixels");
    for (std::size_t size = 8; size + 40 < file.size(); size += 13)
        EXPECT_THAT(refusal({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)}, 1000),
                    testing::StartsWith("expected a PNG picture, found: '"))
            << size;
}

}  // namespace
}  // namespace inkedge
