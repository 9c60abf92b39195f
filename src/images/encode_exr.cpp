#include "images/encode_exr.h"

#include <algorithm>
#include <bit>
#include <string_view>

#include "base/byte_writer.h"
#include "base/deflate.h"
#include "base/parallel.h"

// Written by hand, after "OpenEXR File Layout": OpenImageIO takes a quarter of a second to load, and more than half of
// its time to sort values into channels; OpenEXR's zlib takes many times as long as base/deflate.h.

namespace inkedge::images {
namespace {

using base::ByteWriter;

constexpr std::uint32_t magicNumber = 20000630;
constexpr std::uint32_t version = 2;
constexpr std::uint32_t longNames = 0x400;  // names of over 31 bytes
constexpr std::uint8_t zipCompression = 3;
constexpr int rowsOfBlock = 16;  // of that compression
constexpr std::uint32_t floatChannel = 2;

// One channel of the file and where its values come from.
struct Channel {
    std::string name;
    const Layer* layer;
    int index;  // of the layer's image
};

// In the order of the file: by name.
std::vector<Channel> channelsOf(std::span<const Layer> layers) {
    std::vector<Channel> channels;
    for (const Layer& layer : layers) {
        for (std::size_t c = 0; c < layer.channels.size(); ++c)
            channels.push_back({layer.channels[c], &layer, layer.first + static_cast<int>(c)});
    }
    std::ranges::sort(channels, {}, &Channel::name);
    return channels;
}

void attribute(ByteWriter& file, std::string_view name, std::string_view type, std::size_t size) {
    file.terminated(name);
    file.terminated(type);
    file.number(static_cast<std::uint32_t>(size));
}

void channelList(ByteWriter& file, std::span<const Channel> channels) {
    ByteWriter list;
    for (const Channel& channel : channels) {
        list.terminated(channel.name);
        list.number(floatChannel);
        list.number(std::uint32_t{0});                                       // perceptually linear: no; reserved
        for (int axis = 0; axis < 2; ++axis) list.number(std::uint32_t{1});  // a value for each pixel
    }
    list.number(std::uint8_t{0});
    attribute(file, "channels", "chlist", list.size());
    file.bytes(std::move(list).take());
}

void write(ByteWriter& file, const HeaderEntry& entry) {
    if (const auto* const text = std::get_if<std::string>(&entry.value)) {
        attribute(file, entry.name, "string", text->size());
        file.text(*text);
    } else if (const auto* const matrix = std::get_if<std::array<float, 16>>(&entry.value)) {
        attribute(file, entry.name, "m44f", sizeof *matrix);
        for (const float value : *matrix) file.number(value);
    } else {
        attribute(file, entry.name, "float", sizeof(float));
        file.number(std::get<float>(entry.value));
    }
}

ByteWriter header(Size size, std::span<const Channel> channels, std::span<const HeaderEntry> entries) {
    ByteWriter file;
    file.number(magicNumber);
    file.number(version | longNames);
    channelList(file, channels);
    attribute(file, "compression", "compression", 1);
    file.number(zipCompression);
    for (const char* const window : {"dataWindow", "displayWindow"}) {
        attribute(file, window, "box2i", 4 * sizeof(std::uint32_t));
        for (const int corner : {0, 0, size.width - 1, size.height - 1})
            file.number(static_cast<std::uint32_t>(corner));
    }
    attribute(file, "lineOrder", "lineOrder", 1);
    file.number(std::uint8_t{0});  // from the top down
    write(file, {"pixelAspectRatio", 1.0F});
    attribute(file, "screenWindowCenter", "v2f", 2 * sizeof(float));
    for (int axis = 0; axis < 2; ++axis) file.number(0.0F);
    write(file, {"screenWindowWidth", 1.0F});
    for (const HeaderEntry& entry : entries) write(file, entry);
    file.number(std::uint8_t{0});
    return file;
}

// Rows [begin, end): in each row all values of the first channel, then those of the second, and so on.
std::vector<float> rowsOf(std::span<const Channel> channels, int width, int begin, int end) {
    std::vector<float> rows(static_cast<std::size_t>(width) * static_cast<std::size_t>(end - begin) * channels.size());
    auto to = rows.begin();
    for (int y = begin; y < end; ++y) {
        for (const Channel& channel : channels) {
            std::visit(
                [&](const auto* image) {
                    const auto* from = &(*image)(0, y, channel.index);
                    for (int x = 0; x < width; ++x, from += image->channels()) *to++ = stored(*from);
                },
                channel.layer->image);
        }
    }
    return rows;
}

std::span<const std::uint8_t> bytesOf(const std::vector<float>& values) {
    static_assert(std::endian::native == std::endian::little, "the file's bytes are those in memory");
    return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(float)};
}

// Makes bytes smaller to compress: those at even places before those at odd ones, and of each but the first its
// difference from the one before, plus 128.
std::vector<std::uint8_t> predicted(std::span<const std::uint8_t> bytes) {
    std::vector<std::uint8_t> sorted(bytes.size());
    const std::size_t half = bytes.size() / 2;  // there are four bytes a value
    for (std::size_t i = 0; i < half; ++i) {
        sorted[i] = bytes[2 * i];
        sorted[half + i] = bytes[2 * i + 1];
    }
    std::vector<std::uint8_t> result(sorted.size());
    result[0] = sorted[0];
    for (std::size_t i = 1; i < sorted.size(); ++i)
        result[i] = static_cast<std::uint8_t>(sorted[i] - sorted[i - 1] + 128);
    return result;
}

// What does not become smaller is written as it is: readers know it by its size.
std::vector<std::uint8_t> block(std::span<const Channel> channels, Size size, int begin) {
    const std::vector<float> rows = rowsOf(channels, size.width, begin, std::min(begin + rowsOfBlock, size.height));
    const std::span<const std::uint8_t> bytes = bytesOf(rows);
    std::vector<std::uint8_t> compressed = base::deflated(predicted(bytes), base::DeflateWrapper::Zlib);
    return compressed.size() < bytes.size() ? compressed : std::vector<std::uint8_t>{bytes.begin(), bytes.end()};
}

}  // namespace

std::vector<std::uint8_t> encodeExr(std::span<const Layer> layers, std::span<const HeaderEntry> entries) {
    const Size size = layers.front().size();
    const std::vector<Channel> channels = channelsOf(layers);
    std::vector<std::vector<std::uint8_t>> blocks(
        static_cast<std::size_t>((size.height + rowsOfBlock - 1) / rowsOfBlock));
    base::onEach(blocks.size(),
                 [&](std::size_t i) { blocks[i] = block(channels, size, static_cast<int>(i) * rowsOfBlock); });

    ByteWriter file = header(size, channels, entries);
    std::uint64_t at = file.size() + blocks.size() * sizeof at;
    for (const auto& each : blocks) {
        file.number(at);
        at += 2 * sizeof(std::uint32_t) + each.size();
    }
    file.reserve(at);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        file.number(static_cast<std::uint32_t>(i * rowsOfBlock));
        file.number(static_cast<std::uint32_t>(blocks[i].size()));
        file.bytes(blocks[i]);
        blocks[i] = {};
    }
    return std::move(file).take();
}

}  // namespace inkedge::images
