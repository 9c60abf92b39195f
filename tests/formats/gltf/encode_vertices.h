#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Writes version 1 of meshopt's vertex codec, which the libraries of today's Debian cannot: KHR_meshopt_compression,
/// appendix A, mode 0.
namespace inkedge::vertex_codec {

using Bytes = std::vector<std::uint8_t>;

inline void append(Bytes& bytes, const Bytes& more) { bytes.insert(bytes.end(), more.begin(), more.end()); }

// 16 deltas in 0, 1, 2, 4 or 8 bits each; those that do not fit follow. Nothing if they have no such form.
inline Bytes group(std::span<const std::uint8_t> deltas, unsigned bits) {
    if (bits == 0 || bits == 8) return bits == 0 ? Bytes{} : Bytes{deltas.begin(), deltas.end()};
    const unsigned escape = (1U << bits) - 1U;
    Bytes packed(2 * bits);
    Bytes rest;
    for (unsigned i = 0; i < 16; ++i) {
        const unsigned start = i * bits % 8;
        const unsigned shift = bits == 1 ? start : 8 - bits - start;
        packed[i * bits / 8] =
            static_cast<std::uint8_t>(packed[i * bits / 8] | std::min<unsigned>(deltas[i], escape) << shift);
        if (deltas[i] >= escape) rest.push_back(deltas[i]);
    }
    append(packed, rest);
    return packed;
}

inline bool allZero(std::span<const std::uint8_t> deltas) {
    return std::ranges::count(deltas, 0) == std::ssize(deltas);
}

// The deltas of one byte position under a control mode, with the shortest form of each group.
inline Bytes column(Bytes deltas, unsigned control) {
    if (control == 2) return {};
    if (control == 3) return deltas;
    deltas.resize((deltas.size() + 15) / 16 * 16);
    constexpr std::array<std::array<unsigned, 4>, 2> lengths{{{0, 1, 2, 4}, {1, 2, 4, 8}}};
    Bytes header((deltas.size() / 16 + 3) / 4);
    Bytes groups;
    for (std::size_t g = 0; g < deltas.size() / 16; ++g) {
        const std::span<const std::uint8_t> sixteen{&deltas[16 * g], 16};
        Bytes shortest;
        unsigned chosen = 4;
        for (unsigned k = 0; k < 4; ++k) {
            if (lengths[control][k] == 0 && !allZero(sixteen)) continue;
            const Bytes form = group(sixteen, lengths[control][k]);
            if (chosen < 4 && form.size() >= shortest.size()) continue;
            chosen = k;
            shortest = form;
        }
        header[g / 4] = static_cast<std::uint8_t>(header[g / 4] | chosen << 2 * (g % 4));
        append(groups, shortest);
    }
    append(header, groups);
    return header;
}

inline std::uint32_t numberAt(const std::uint8_t* bytes, std::size_t size) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < size; ++i) number |= static_cast<std::uint32_t>(bytes[i]) << 8 * i;
    return number;
}

inline std::uint32_t zigzag(std::uint32_t difference, unsigned bits) {
    const std::uint32_t mask = bits == 8 ? 0xffU : 0xffffU;
    const bool negative = (difference >> (bits - 1) & 1U) != 0;
    return (negative ? ~(difference << 1U) : difference << 1U) & mask;
}

// The 4 bytes that lead from one element to the next in a channel.
inline std::array<std::uint8_t, 4> delta(const std::uint8_t* before, const std::uint8_t* after, std::uint8_t mode) {
    std::array<std::uint8_t, 4> bytes{};
    const std::size_t size = mode == 0 ? 1 : mode == 1 ? 2 : 4;
    for (std::size_t k = 0; k < 4; k += size) {
        const std::uint32_t a = numberAt(before + k, size);
        const std::uint32_t b = numberAt(after + k, size);
        const std::uint32_t number =
            size == 4 ? std::rotl(a ^ b, mode >> 4) : zigzag(b - a, static_cast<unsigned>(8 * size));
        for (std::size_t i = 0; i < size; ++i) bytes[k + i] = static_cast<std::uint8_t>(number >> 8 * i & 255U);
    }
    return bytes;
}

/// @param modes    one per 4 bytes of an element: 0 bytes, 1 pairs of bytes, 2 + 16 r: XOR, turned by r bits
/// @param control  0 to 3 for all bytes; 4: the one that is shortest. 2 is taken where all deltas are 0 only.
inline Bytes encode(const std::uint8_t* elements, std::size_t count, std::size_t stride, const Bytes& modes,
                    unsigned control = 4) {
    Bytes bytes{0xa1};
    const std::size_t block = std::min<std::size_t>(8192 / stride / 16 * 16, 256);
    const std::uint8_t* last = elements;
    for (std::size_t begin = 0; begin < count; begin += block) {
        const std::size_t size = std::min(block, count - begin);
        std::vector<Bytes> columns(stride);
        for (std::size_t i = begin; i < begin + size; last = elements + stride * i++)
            for (std::size_t channel = 0; channel < stride / 4; ++channel) {
                const auto four = delta(last + 4 * channel, elements + i * stride + 4 * channel, modes[channel]);
                for (std::size_t k = 0; k < 4; ++k) columns[4 * channel + k].push_back(four[k]);
            }
        Bytes controls(stride / 4);
        Bytes data;
        for (std::size_t k = 0; k < stride; ++k) {
            unsigned chosen = control == 4 ? 3 : control;
            if (control == 2) chosen = 1;
            if (control == 4)
                for (const unsigned other : {0U, 1U})
                    if (column(columns[k], other).size() < column(columns[k], chosen).size()) chosen = other;
            if (control != 3 && allZero(columns[k])) chosen = 2;
            controls[k / 4] = static_cast<std::uint8_t>(controls[k / 4] | chosen << 2 * (k % 4));
            append(data, column(columns[k], chosen));
        }
        append(bytes, controls);
        append(bytes, data);
    }
    bytes.resize(bytes.size() + 24 - std::min<std::size_t>(24, stride + stride / 4));
    bytes.insert(bytes.end(), elements, elements + stride);
    append(bytes, modes);
    return bytes;
}

}  // namespace inkedge::vertex_codec
