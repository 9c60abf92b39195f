#include "formats/gltf/vertex_codec.h"

#include <algorithm>
#include <array>
#include <bit>

#include <fmt/format.h>

#include "base/message.h"

namespace inkedge::gltf {

namespace {

constexpr std::size_t groupSize = 16;      // elements whose deltas have one bit length
constexpr std::size_t channelSize = 4;     // bytes whose deltas are taken in one way
constexpr std::size_t maximumBlock = 256;  // elements

using ByteSpan = std::span<const std::uint8_t>;
using BlockDeltas = std::array<std::uint8_t, maximumBlock>;  // of one byte of the elements

// ByteSpan that are taken one after the other.
class Stream {
public:
    explicit Stream(ByteSpan bytes) : bytes_{bytes} {}

    ByteSpan take(std::size_t count) {
        if (count > bytes_.size() - at_)
            base::refuse(fmt::format("expected {} bytes of vertex data from byte {}, found {}", count, at_,
                                     bytes_.size() - at_));
        at_ += count;
        return bytes_.subspan(at_ - count, count);
    }
    [[nodiscard]] std::size_t left() const { return bytes_.size() - at_; }

private:
    ByteSpan bytes_;
    std::size_t at_ = 0;
};

// The deltas of a group in 0, 1, 2, 4 or 8 bits each. Where all bits are set, the delta is a byte after the group.
void readGroup(Stream& stream, unsigned bits, std::uint8_t* deltas) {
    if (bits == 0) {
        std::fill_n(deltas, groupSize, std::uint8_t{0});
        return;
    }
    const ByteSpan packed = stream.take(groupSize * bits / 8);
    if (bits == 8) {
        std::ranges::copy(packed, deltas);
        return;
    }
    const unsigned escape = (1U << bits) - 1U;
    for (unsigned i = 0; i < groupSize; ++i) {
        const unsigned start = i * bits % 8;  // of 1 bit the lowest is first, else the highest
        const unsigned shift = bits == 1 ? start : 8 - bits - start;
        const unsigned delta = static_cast<unsigned>(packed[i * bits / 8]) >> shift & escape;
        deltas[i] = delta == escape ? stream.take(1)[0] : static_cast<std::uint8_t>(delta);
    }
}

// The deltas of one byte of a block's count elements. Only groups are filled up to 16 elements, plain bytes are not.
void readDeltas(Stream& stream, unsigned control, std::size_t count, BlockDeltas& deltas) {
    constexpr std::array<std::array<unsigned, 4>, 2> bitLengths{{{0, 1, 2, 4}, {1, 2, 4, 8}}};
    if (control == 2) return deltas.fill(0);
    if (control == 3) {
        std::ranges::copy(stream.take(count), deltas.begin());
        return;
    }
    const std::size_t groups = (count + groupSize - 1) / groupSize;
    const ByteSpan lengths = stream.take((groups + 3) / 4);
    for (std::size_t group = 0; group < groups; ++group) {
        const unsigned length = static_cast<unsigned>(lengths[group / 4]) >> 2 * (group % 4) & 3U;
        readGroup(stream, bitLengths[control][length], &deltas[group * groupSize]);
    }
}

// What was a difference before its sign went to the lowest bit.
template <class Number>
Number unzigzag(Number value) {
    const auto half = static_cast<Number>(value >> 1U);
    return (value & 1U) != 0 ? static_cast<Number>(~half) : half;
}

std::uint32_t joined(const std::uint8_t* bytes, std::size_t count) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < count; ++i) number |= static_cast<std::uint32_t>(bytes[i]) << 8 * i;
    return number;
}

void split(std::uint32_t number, std::uint8_t* bytes, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<std::uint8_t>(number >> 8 * i & 255U);
}

// Adds the deltas of a channel to the last element's.
void addDeltas(std::uint8_t mode, const std::array<std::uint8_t, channelSize>& deltas, std::uint8_t* last) {
    if (mode == 0) {
        for (std::size_t k = 0; k < channelSize; ++k)
            last[k] = static_cast<std::uint8_t>(last[k] + unzigzag(deltas[k]));
    } else if (mode == 1) {
        for (std::size_t k = 0; k < channelSize; k += 2)
            split(joined(last + k, 2) + unzigzag(static_cast<std::uint16_t>(joined(&deltas[k], 2))), last + k, 2);
    } else {
        const std::uint32_t difference = std::rotr(joined(deltas.data(), channelSize), mode >> 4);
        split(joined(last, channelSize) ^ difference, last, channelSize);
    }
}

void checkModes(ByteSpan modes) {
    for (const std::uint8_t mode : modes)
        if (const unsigned kind = mode & 15U; kind > 2 || (kind < 2 && mode != kind))
            base::refuse(fmt::format("expected channel modes 0, 1 and 2, found 0x{:02x}", mode));
}

// Reads a block, whose elements continue from the last one.
void readBlock(Stream& stream, ByteSpan modes, std::span<std::uint8_t> last, std::span<std::uint8_t> elements) {
    const std::size_t stride = last.size();
    const std::size_t count = elements.size() / stride;
    const ByteSpan controls = stream.take(stride / channelSize);
    std::array<BlockDeltas, channelSize> deltas;
    for (std::size_t channel = 0; channel < modes.size(); ++channel) {
        for (std::size_t k = 0; k < channelSize; ++k)
            readDeltas(stream, static_cast<unsigned>(controls[channel]) >> 2 * k & 3U, count, deltas[k]);
        std::uint8_t* const before = &last[channel * channelSize];
        for (std::size_t i = 0; i < count; ++i) {
            addDeltas(modes[channel], {deltas[0][i], deltas[1][i], deltas[2][i], deltas[3][i]}, before);
            std::copy_n(before, channelSize, &elements[i * stride + channel * channelSize]);
        }
    }
}

}  // namespace

std::vector<std::uint8_t> decodeVertices(std::span<const std::uint8_t> data, std::size_t count, std::size_t stride) {
    constexpr std::size_t smallestTail = 24;
    const std::size_t tail = stride + stride / channelSize;
    const std::size_t padded = std::max(tail, smallestTail);
    if (data.size() < 1 + padded)
        base::refuse(fmt::format("expected at least {} bytes of vertex data, found {}", 1 + padded, data.size()));
    const ByteSpan first = data.last(tail).first(stride);
    const ByteSpan modes = data.last(stride / channelSize);
    checkModes(modes);

    Stream stream{data.subspan(1, data.size() - 1 - padded)};
    std::vector<std::uint8_t> last{first.begin(), first.end()};
    std::vector<std::uint8_t> elements(count * stride);
    const std::size_t blockSize = std::min(8192 / stride / groupSize * groupSize, maximumBlock);
    for (std::size_t i = 0; i < count; i += blockSize)
        readBlock(stream, modes, last,
                  std::span{elements}.subspan(i * stride, std::min(blockSize, count - i) * stride));
    if (stream.left() != 0)
        base::refuse(
            fmt::format("expected vertex data to end with {} elements, found {} bytes more", count, stream.left()));
    return elements;
}

}  // namespace inkedge::gltf
