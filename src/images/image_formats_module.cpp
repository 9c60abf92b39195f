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
#include <optional>
#include <string>
#include <vector>

#include <inkedge/export.h>

#include "modules/failure.h"

namespace inkedge::images {
namespace {

constexpr const char* notThisFile = "; write it again, as .png or .exr";
constexpr int rowsAtOnce = 64;

OIIO::ImageSpec describe(const Layer& layer, SampleType type, std::optional<double> dpi) {
    const Size size = layer.size();
    OIIO::ImageSpec spec{size.width, size.height, static_cast<int>(layer.channels.size()),
                         type == SampleType::Uint8 ? OIIO::TypeUInt8 : OIIO::TypeFloat};
    spec.channelnames = layer.channels;
    const auto alpha = std::find(spec.channelnames.begin(), spec.channelnames.end(), "A");
    if (alpha != spec.channelnames.end()) spec.alpha_channel = static_cast<int>(alpha - spec.channelnames.begin());
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (dpi) {
        spec.attribute("ResolutionUnit", "in");
        for (const char* axis : {"XResolution", "YResolution"}) spec.attribute(axis, static_cast<float>(*dpi));
    }
    return spec;
}

bool writeRows(OIIO::ImageOutput& output, const OIIO::ImageSpec& spec, const Layer& layer) {
    std::vector<float> rows;
    for (int begin = 0; begin < spec.height; begin += rowsAtOnce) {
        const int end = std::min(begin + rowsAtOnce, spec.height);
        rows.clear();
        const auto append = [&](const auto* image) {
            for (int y = begin; y < end; ++y) {
                for (int x = 0; x < spec.width; ++x) {
                    for (int c = 0; c < spec.nchannels; ++c) rows.push_back(stored((*image)(x, y, layer.first + c)));
                }
            }
        };
        std::visit(append, layer.image);
        if (!output.write_scanlines(begin, end, 0, OIIO::TypeFloat, rows.data())) return false;
    }
    return true;
}

EncodedPicture encodeFile(const Layer& layer, SampleType type, std::optional<double> dpi) {
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create("tiff");
    if (!output) return {{}, modules::oneLine(OIIO::geterror())};
    const OIIO::ImageSpec spec = describe(layer, type, dpi);
    EncodedPicture result;
    OIIO::Filesystem::IOVecOutput memory{result.bytes};
    const bool written = output->set_ioproxy(&memory) && output->open("tiff", spec) &&
                         writeRows(*output, spec, layer) && output->close();
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
    constexpr std::uint64_t maxValues = std::uint64_t{1} << 30U;  // 4 GiB of floats; a header costs nothing
    const std::uint64_t values = static_cast<std::uint64_t>(spec.width) * static_cast<std::uint64_t>(spec.height) *
                                 static_cast<std::uint64_t>(spec.nchannels);
    if (values > maxValues) {
        result.failure = "expected at most " + std::to_string(maxValues) +
                         " values, width x height x channels, found " + std::to_string(spec.width) + " x " +
                         std::to_string(spec.height) + " x " + std::to_string(spec.nchannels);
        return result;
    }
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

extern "C" INKEDGE_API const ImageFormats* inkedge_image_formats_6() noexcept {
    static constexpr ImageFormats formats{
        [](const Layer& layer, SampleType type, std::optional<double> dpi) {
            return modules::guarded([&] { return encodeFile(layer, type, dpi); });
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
