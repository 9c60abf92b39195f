#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <inkedge/encode_png.h>
#include <inkedge/error.h>

#include "base/deflate.h"

// The file format: PNG (third edition), W3C Recommendation.
namespace inkedge {
namespace {

using Bytes = std::vector<std::uint8_t>;

enum class ColorType : std::uint8_t { Grey = 0, Rgb = 2, Palette = 3, RgbAlpha = 6 };  // 11.2.1

ColorType colorType(int channels) {
    switch (channels) {
        case 1:
            return ColorType::Grey;
        case 3:
            return ColorType::Rgb;
        case 4:
            return ColorType::RgbAlpha;
        default:
            throw Error{Error::Kind::Usage,
                        fmt::format("PNG: expected a picture of 1, 3 or 4 channels, found {}", channels)};
    }
}

/// A picture of few colours: one byte a pixel.
struct Palette {
    Bytes colors;     // three bytes each
    Bytes opacities;  // of four channels; else empty
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
            if (added) palette.colors.insert(palette.colors.end(), pixel, pixel + 3);
            if (added && channels == 4) palette.opacities.push_back(pixel[3]);
            index = found->second;
            last = color;
        }
        palette.indices.mutablePixels()[i] = index;
    }
    return palette;
}

constexpr std::uint32_t maxNumber = 0x7FFFFFFF;  // 7.1

void appendNumber(Bytes& bytes, std::uint32_t value) {
    for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
}

/// Length, type, data, and the checksum of type and data (5.3).
void appendChunk(Bytes& file, std::string_view type, std::span<const std::uint8_t> data) {
    appendNumber(file, static_cast<std::uint32_t>(data.size()));
    const std::size_t begin = file.size();
    file.insert(file.end(), type.begin(), type.end());
    file.insert(file.end(), data.begin(), data.end());
    appendNumber(file, base::crc32(std::span{file}.subspan(begin)));
}

/// The rows as differences from the rows above (9.2, filter type Up), samples of 16 bits with the more significant byte
/// first. In pictures of lines and maps of few values rows repeat each other.
template <class Sample>
Bytes filteredRows(const Image<Sample>& image) {
    constexpr std::uint8_t up = 2;
    const std::size_t samples = static_cast<std::size_t>(image.size().width) * image.channels();
    Bytes filtered(static_cast<std::size_t>(image.size().height) * (samples * sizeof(Sample) + 1));
    const std::vector<Sample> zeros(samples);
    const Sample* above = zeros.data();
    std::uint8_t* to = filtered.data();
    for (int y = 0; y < image.size().height; ++y) {
        const Sample* const row = &image.at(0, y);
        *to++ = up;
        for (std::size_t i = 0; i < samples; ++i) {
            if constexpr (sizeof(Sample) == 2) to[2 * i] = static_cast<std::uint8_t>((row[i] >> 8) - (above[i] >> 8));
            to[sizeof(Sample) * (i + 1) - 1] = static_cast<std::uint8_t>(row[i] - above[i]);
        }
        to += sizeof(Sample) * samples;
        above = row;
    }
    return filtered;
}

template <class Sample>
void expectEncodable(const Image<Sample>& image) {
    static_cast<void>(colorType(image.channels()));
    if (image.empty()) throw Error{Error::Kind::Usage, "PNG: expected a picture of at least one pixel, found none"};
}

// @return 0 if none is given, or one that a file cannot tell
std::uint32_t pixelsPerMetre(std::optional<double> dpi) {
    constexpr double metresPerInch = 0.0254;
    const double pixels = std::round(dpi.value_or(0.0) / metresPerInch);
    return pixels >= 1.0 && pixels <= maxNumber ? static_cast<std::uint32_t>(pixels) : 0;
}

/// @param palette  of the picture, whose indices the image then holds; or null
template <class Sample>
Bytes encoded(const Image<Sample>& image, const Palette* palette, std::optional<double> dpi) {
    constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
    Bytes file{signature.begin(), signature.end()};
    Bytes header;
    appendNumber(header, static_cast<std::uint32_t>(image.size().width));
    appendNumber(header, static_cast<std::uint32_t>(image.size().height));
    const ColorType type = palette != nullptr ? ColorType::Palette : colorType(image.channels());
    header.insert(header.end(), {8 * sizeof(Sample), static_cast<std::uint8_t>(type), 0, 0, 0});
    appendChunk(file, "IHDR", header);
    if (palette != nullptr) {
        appendChunk(file, "PLTE", palette->colors);
        if (!palette->opacities.empty()) appendChunk(file, "tRNS", palette->opacities);
    }
    if (const std::uint32_t pixels = pixelsPerMetre(dpi); pixels > 0) {
        constexpr std::uint8_t perMetre = 1;
        Bytes density;
        appendNumber(density, pixels);
        appendNumber(density, pixels);
        density.push_back(perMetre);
        appendChunk(file, "pHYs", density);
    }
    const Bytes compressed = base::deflated(filteredRows(image), base::DeflateWrapper::Zlib);
    for (std::size_t at = 0; at < compressed.size(); at += maxNumber) {
        const std::size_t size = std::min<std::size_t>(compressed.size() - at, maxNumber);
        appendChunk(file, "IDAT", std::span{compressed}.subspan(at, size));
    }
    appendChunk(file, "IEND", {});
    return file;
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
