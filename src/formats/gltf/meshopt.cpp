#include "formats/gltf/meshopt.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "base/message.h"
#include "formats/gltf/vertex_codec.h"

namespace inkedge::gltf {

namespace {

using Bytes = std::vector<std::uint8_t>;
using Data = std::span<const std::uint8_t>;

const MeshoptFunctions& meshoptimizer() { return modules::functionsOf<meshoptModule>(Error::Kind::Input); }

void checkLayout(const MeshoptData& view) {
    if (view.count == 0) base::refuse("expected a count of at least 1, found 0");
    if (view.mode == "ATTRIBUTES") {
        if (view.stride == 0 || view.stride % 4 != 0 || view.stride > 256)
            base::refuse(fmt::format("expected a byteStride of 4, 8, ... 256 in ATTRIBUTES, found {}", view.stride));
        return;
    }
    if (view.mode != "TRIANGLES" && view.mode != "INDICES")
        base::refuse("expected mode ATTRIBUTES, TRIANGLES or INDICES, found " + base::quote(view.mode));
    if (view.stride != 2 && view.stride != 4)
        base::refuse(fmt::format("expected a byteStride of 2 or 4 in {}, found {}", view.mode, view.stride));
    if (view.mode == "TRIANGLES" && view.count % 3 != 0)
        base::refuse(fmt::format("expected a count that is a multiple of 3 in TRIANGLES, found {}", view.count));
}

// How many bytes a byte of data stands for at most, by the largest block of zeros: version 0 of the vertex codec keeps
// 2 bits for 16 bytes, version 1 keeps 2 bits for 256; of triangles and indices each takes a byte.
std::uint64_t highestRatio(const MeshoptData& view, Data data) {
    if (view.mode != "ATTRIBUTES") return 12;
    return data[0] == vertexCodecVersion1 ? 1024 : 64;
}

// Checks before memory is taken.
void checkSize(const MeshoptData& view, Data data, std::uint64_t bytesLeft) {
    if (view.count > bytesLeft / view.stride)
        base::refuse(
            fmt::format("expected at most {} bytes more in decompressed data, found {} elements of {} bytes; "
                        "raise max-decompressed-size",
                        bytesLeft, view.count, view.stride));
    const std::uint64_t smallest = data.empty() ? 1 : view.count * view.stride / highestRatio(view, data);
    if (smallest > data.size())
        base::refuse(fmt::format("expected compressed data of at least {} bytes for {} elements of {} bytes, found {}",
                                 smallest, view.count, view.stride, data.size()));
}

// ---- filters

// A colour of 4 numbers from luma, two differences and an alpha whose highest bit says how many bits there are:
// KHR_meshopt_compression, appendix B, filter 4.
template <class Number>
void decodeColor(std::array<Number, 4>& color) {
    using Signed = std::make_signed_t<Number>;
    constexpr int largest = std::numeric_limits<Number>::max();
    const int bits = std::bit_width(color[3]);
    if (bits == 0) return color.fill(0);  // no alpha of the filter's
    const int one = (1 << bits) - 1;
    const int luma = color[0];
    const int orange = static_cast<Signed>(color[1]);
    const int green = static_cast<Signed>(color[2]);
    const int alpha = color[3] & (one >> 1);
    const std::array whole{luma + orange - green, luma + green, luma - orange - green, alpha << 1 | (alpha & 1)};
    for (std::size_t i = 0; i < 4; ++i)
        color[i] = static_cast<Number>(std::clamp<long>(std::lround(1.0 * whole[i] * largest / one), 0, largest));
}

template <class Number>
void decodeColors(void* elements, std::size_t count) {
    auto* at = static_cast<std::uint8_t*>(elements);
    for (std::size_t i = 0; i < count; ++i, at += sizeof(std::array<Number, 4>)) {
        std::array<Number, 4> color;
        std::memcpy(color.data(), at, sizeof color);
        decodeColor(color);
        std::memcpy(at, color.data(), sizeof color);
    }
}

void colorFilter(void* elements, std::size_t count, std::size_t stride) {
    stride == 4 ? decodeColors<std::uint8_t>(elements, count) : decodeColors<std::uint16_t>(elements, count);
}

MeshoptFunctions::Filter filterOf(const MeshoptData& view) {
    struct Known {
        std::string_view name;
        MeshoptFunctions::Filter filter;
        bool fits;  // the stride
    };
    const bool fourNumbers = view.stride == 4 || view.stride == 8;
    const std::array known{
        Known{"NONE", nullptr, true},
        Known{"OCTAHEDRAL", meshoptimizer().octahedral, fourNumbers},
        Known{"QUATERNION", meshoptimizer().quaternion, view.stride == 8},
        Known{"EXPONENTIAL", meshoptimizer().exponential, view.stride % 4 == 0},
        Known{"COLOR", colorFilter, fourNumbers},
    };
    for (const Known& each : known) {
        if (view.filter != each.name) continue;
        if (each.filter != nullptr && view.mode != "ATTRIBUTES")
            base::refuse(fmt::format("expected filter NONE in {}, found {}", view.mode, view.filter));
        if (!each.fits)
            base::refuse(fmt::format("expected a byteStride that filter {} takes, found {}", view.filter, view.stride));
        return each.filter;
    }
    base::refuse("expected filter NONE, OCTAHEDRAL, QUATERNION, EXPONENTIAL or COLOR, found " +
                 base::quote(view.filter));
}

// ---- modes

Bytes decode(const MeshoptData& view, Data data) {
    const MeshoptFunctions& library = meshoptimizer();
    const bool vertices = view.mode == "ATTRIBUTES";
    const auto decoder = vertices ? library.vertices : view.mode == "INDICES" ? library.indices : library.triangles;
    Bytes bytes(view.count * view.stride);
    const int failure = decoder(bytes.data(), view.count, view.stride, data.data(), data.size());
    if (failure == 0) return bytes;
    const bool unknown = failure == -1;
    if (unknown && vertices && data[0] == vertexCodecVersion1) return decodeVertices(data, view.count, view.stride);
    if (unknown)
        base::refuse(fmt::format("expected data that start with {}, found 0x{:02x}",
                                 vertices                 ? "0xa0 or 0xa1"
                                 : view.mode == "INDICES" ? "0xd0 or 0xd1"
                                                          : "0xe0 or 0xe1",
                                 data[0]));
    base::refuse(fmt::format("expected {} elements in {} bytes, found data that do not decode (error {})", view.count,
                             data.size(), failure));
}

}  // namespace

Bytes decodeMeshopt(const MeshoptData& view, Data data, std::uint64_t bytesLeft) {
    checkLayout(view);
    const MeshoptFunctions::Filter filter = filterOf(view);
    checkSize(view, data, bytesLeft);
    Bytes bytes = decode(view, data);
    if (filter != nullptr) filter(bytes.data(), view.count, view.stride);
    return bytes;
}

}  // namespace inkedge::gltf
