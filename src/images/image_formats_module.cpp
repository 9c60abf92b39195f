#include "images/image_formats.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <inkedge/export.h>

#include "modules/failure.h"

namespace inkedge::images {
namespace {

constexpr const char* notThisFile = "; write it again, as .png or .exr";
constexpr int rowsAtOnce = 64;  // a multiple of every scanline block that the formats compress

OIIO::TypeDesc typeDesc(SampleType type) {
    switch (type) {
        case SampleType::Uint8:
            return OIIO::TypeUInt8;
        case SampleType::Half:
            return OIIO::TypeHalf;
        case SampleType::Float:
            break;
    }
    return OIIO::TypeFloat;
}

Size sizeOf(const Layer& layer) {
    return std::visit([](const auto* image) { return image->size(); }, layer.image);
}

OIIO::ImageSpec describe(FileFormat format, std::span<const Layer> layers, std::span<const HeaderEntry> header) {
    const Size size = sizeOf(layers.front());
    OIIO::ImageSpec spec{size.width, size.height, 0, typeDesc(layers.front().stored)};
    for (const Layer& layer : layers) {
        spec.channelnames.insert(spec.channelnames.end(), layer.channels.begin(), layer.channels.end());
        spec.channelformats.insert(spec.channelformats.end(), layer.channels.size(), typeDesc(layer.stored));
    }
    spec.nchannels = static_cast<int>(spec.channelnames.size());
    const auto alpha = std::find(spec.channelnames.begin(), spec.channelnames.end(), "A");
    if (alpha != spec.channelnames.end()) spec.alpha_channel = static_cast<int>(alpha - spec.channelnames.begin());
    if (format == FileFormat::Tiff) {
        spec.attribute("oiio:UnassociatedAlpha", 1);
        spec.channelformats.clear();  // TIFF has one type per picture
    }
    for (const HeaderEntry& entry : header) {
        spec.attribute(entry.name, entry.values.size() == 16 ? OIIO::TypeMatrix44 : OIIO::TypeFloat,
                       entry.values.data());
    }
    return spec;
}

float normalised(float value) { return value; }
float normalised(std::uint8_t value) { return static_cast<float>(value) / 255.0F; }
float normalised(std::uint16_t value) { return static_cast<float>(value); }
float normalised(std::uint32_t value) { return static_cast<float>(value); }

/// Copies rows [begin, end) of an image into interleaved rows of `stride` channels, from channel `first` on.
template <class T>
void interleave(const Image<T>& image, int begin, int end, std::size_t first, std::size_t stride,
                std::vector<float>& rows) {
    std::size_t pixel = first;
    for (int y = begin; y < end; ++y) {
        for (int x = 0; x < image.size().width; ++x, pixel += stride) {
            for (int c = 0; c < image.channels(); ++c) {
                rows[pixel + static_cast<std::size_t>(c)] = normalised(image(x, y, c));
            }
        }
    }
}

bool writeRows(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec, std::span<const Layer> layers) {
    const auto stride = static_cast<std::size_t>(spec.nchannels);
    std::vector<float> rows(static_cast<std::size_t>(spec.width) * stride *
                            static_cast<std::size_t>(std::min(rowsAtOnce, spec.height)));
    for (int begin = 0; begin < spec.height; begin += rowsAtOnce) {
        const int end = std::min(begin + rowsAtOnce, spec.height);
        std::size_t first = 0;
        for (const Layer& layer : layers) {
            std::visit([&](const auto* image) { interleave(*image, begin, end, first, stride, rows); }, layer.image);
            first += layer.channels.size();
        }
        if (!output.write_scanlines(begin, end, 0, OIIO::TypeFloat, rows.data())) return false;
    }
    return true;
}

EncodedPicture encodeFile(FileFormat format, std::span<const Layer> layers, std::span<const HeaderEntry> header) {
    const char* const formatName = format == FileFormat::Tiff ? "tiff" : "openexr";
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(formatName);
    if (!output) return {{}, modules::oneLine(OIIO::geterror())};
    const OIIO::ImageSpec spec = describe(format, layers, header);
    EncodedPicture result;
    OIIO::Filesystem::IOVecOutput memory{result.bytes};
    const bool written = output->set_ioproxy(&memory) && output->open(formatName, spec) &&
                         writeRows(*output, spec, layers) && output->close();
    if (!written) result.failure = modules::oneLine(output->geterror());
    return result;
}

ReadPicture readFile(const std::filesystem::path& path) {
    OIIO::ImageSpec request;
    request.attribute("oiio:UnassociatedAlpha", 1);
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string(), &request);
    ReadPicture result;
    if (!input) {
        result.failure =
            "expected a picture of a known format, found: " + modules::oneLine(OIIO::geterror()) + notThisFile;
        return result;
    }
    const OIIO::ImageSpec& spec = input->spec();
    result.image = Image<float>{{spec.width, spec.height}, spec.nchannels};
    result.integers = !spec.format.is_floating_point();
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, result.image.mutablePixels().data())) {
        result.failure = "expected a whole picture, found: " + modules::oneLine(input->geterror()) + notThisFile;
    }
    return result;
}

/// Wraps an image without copying it.
OIIO::ImageBuf view(const Image<float>& image) {
    const OIIO::ImageSpec spec{image.size().width, image.size().height, image.channels(), OIIO::TypeFloat};
    return OIIO::ImageBuf{spec, const_cast<float*>(image.pixels().data())};  // only read, but ImageBuf takes no const
}

Differences measure(const Image<float>& a, const Image<float>& b, double level) {
    const auto threshold = static_cast<float>(level);
    const OIIO::ImageBuf left = view(a);
    const OIIO::ImageBuf right = view(b);
    const auto found = OIIO::ImageBufAlgo::compare(left, right, threshold, threshold);
    if (left.has_error())
        return {.failure = modules::oneLine(left.geterror())};  // found.error only says that they differ
    return {found.nfail, found.maxerror, found.maxx, found.maxy, found.meanerror, {}};
}

DecodedPicture decodeJpeg(std::span<const std::uint8_t> bytes, std::uint64_t maxPixels) {
    OIIO::Filesystem::IOMemReader memory{const_cast<std::uint8_t*>(bytes.data()), bytes.size()};  // it only reads
    const auto input = OIIO::ImageInput::open("picture.jpg", nullptr, &memory);
    if (!input) return {.image = {}, .failure = modules::oneLine(OIIO::geterror())};
    const OIIO::ImageSpec& spec = input->spec();
    const auto pixels = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height);
    if (pixels > maxPixels) {
        return {.image = {},
                .failure = "at most " + std::to_string(maxPixels) + " pixels were expected, there are " +
                           std::to_string(spec.width) + "x" + std::to_string(spec.height) + "; raise max-image-pixels"};
    }
    const auto channels = static_cast<std::size_t>(spec.nchannels);
    std::vector<std::uint8_t> read(static_cast<std::size_t>(pixels) * channels);
    if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeUInt8, read.data()))
        return {.image = {}, .failure = modules::oneLine(input->geterror())};
    DecodedPicture picture{Image<std::uint8_t>{{spec.width, spec.height}, 4, 255}, {}};
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t c = 0; c < 3; ++c) {
            picture.image.mutablePixels()[4 * i + c] = read[channels * i + (channels < 3 ? 0 : c)];
        }
    }
    return picture;
}

}  // namespace

extern "C" INKEDGE_API const ImageFormats* inkedge_image_formats_4() noexcept {
    static constexpr ImageFormats formats{
        [](FileFormat format, std::span<const Layer> layers, std::span<const HeaderEntry> header) {
            return modules::guarded([&] { return encodeFile(format, layers, header); });
        },
        [](const std::filesystem::path& path) { return modules::guarded([&] { return readFile(path); }); },
        [](std::span<const std::uint8_t> bytes, std::uint64_t maxPixels) {
            return modules::guarded([&] { return decodeJpeg(bytes, maxPixels); });
        },
        [](const Image<float>& a, const Image<float>& b, double level) {
            return modules::guarded([&] { return measure(a, b, level); });
        }};
    return &formats;
}

}  // namespace inkedge::images
