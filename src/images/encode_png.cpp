#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
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

/// A sample as PNG has it: of 16 bits with the more significant byte first (7.1), less the one to its left (9.2, filter
/// type Sub) byte by byte.
std::uint8_t filtered(std::uint8_t sample, std::uint8_t left) { return static_cast<std::uint8_t>(sample - left); }
std::uint16_t filtered(std::uint16_t sample, std::uint16_t left) {
    const auto high = static_cast<std::uint16_t>((sample & 0xFF00) - (left & 0xFF00));
    const auto low = static_cast<std::uint16_t>((sample - left) & 0xFF);
    if constexpr (std::endian::native == std::endian::big) return static_cast<std::uint16_t>(high | low);
    return static_cast<std::uint16_t>(high >> 8 | low << 8);
}

/// Filters rows one after the other.
template <class Sample>
class RowFilter {
public:
    RowFilter(std::size_t samples, std::size_t channels) : samples_{samples}, channels_{channels}, row_(samples) {}

    [[nodiscard]] std::size_t bytes() const noexcept { return 1 + samples_ * sizeof(Sample); }

    /// Writes the filter's type and the row. One of long runs, as of lines and of maps of few values, stands as it is;
    /// another as differences, which are small, and repeat each other where a surface is flat.
    void write(const Sample* row, std::uint8_t* to) {
        constexpr std::uint8_t none = 0;
        constexpr std::uint8_t sub = 1;
        constexpr std::size_t shortRun = 16;
        std::size_t changes = 0;
        for (std::size_t i = channels_; i < samples_; ++i) changes += row[i] != row[i - channels_] ? 1 : 0;
        const bool runs = shortRun * changes <= samples_;
        const std::size_t plain = runs ? samples_ : channels_;
        for (std::size_t i = 0; i < plain; ++i) row_[i] = filtered(row[i], Sample{0});
        for (std::size_t i = plain; i < samples_; ++i) row_[i] = filtered(row[i], row[i - channels_]);
        *to = runs ? none : sub;
        std::memcpy(to + 1, row_.data(), samples_ * sizeof(Sample));
    }

private:
    std::size_t samples_;
    std::size_t channels_;
    std::vector<Sample> row_;
};

/// The image's data (10.1): its filtered rows, compressed.
template <class Sample>
Bytes compressedRows(const Image<Sample>& image) {
    constexpr std::size_t usualBlock = 64 << 10;  // stays in the cache between filter and compressor
    const auto channels = static_cast<std::size_t>(image.channels());
    const auto samples = static_cast<std::size_t>(image.size().width) * channels;
    RowFilter<Sample> filter{samples, channels};
    const std::size_t bytes = filter.bytes();
    const auto height = static_cast<std::size_t>(image.size().height);
    Bytes block(bytes * std::clamp<std::size_t>(usualBlock / bytes, 1, height));
    base::Deflater deflater{base::DeflateWrapper::Zlib};
    std::size_t filled = 0;
    for (std::size_t y = 0; y < height; ++y) {
        filter.write(&image.pixels()[y * samples], &block[filled]);
        filled += bytes;
        if (filled < block.size() && y + 1 < height) continue;
        deflater.add(std::span{block}.first(filled));
        filled = 0;
    }
    return deflater.finish();
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
    const Bytes compressed = compressedRows(image);
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
