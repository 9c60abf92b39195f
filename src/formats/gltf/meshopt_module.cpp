#include "formats/gltf/meshopt.h"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <inkedge/export.h>

#include "base/message.h"

namespace inkedge::gltf {

using namespace load;

namespace {

// A block of 256 elements takes at least a 64th of its size: the vertex codec keeps 2 bits for 16 bytes, the index
// codecs at least a byte for a triangle or an index.
constexpr std::uint64_t highestRatio = 64;

using Decode = int (*)(void* destination, std::size_t count, std::size_t stride, const unsigned char* data,
                       std::size_t size);
using Filter = void (*)(void* buffer, std::size_t count, std::size_t stride);

Decode decoderOf(const MeshoptData& view) {
    const bool indices = view.stride == 2 || view.stride == 4;
    if (view.mode == "ATTRIBUTES") {
        if (view.stride == 0 || view.stride % 4 != 0 || view.stride > 256)
            refuse(fmt::format("expected a byteStride of 4, 8, ... 256 in ATTRIBUTES, found {}", view.stride));
        return meshopt_decodeVertexBuffer;
    }
    if (view.mode != "TRIANGLES" && view.mode != "INDICES")
        refuse("expected mode ATTRIBUTES, TRIANGLES or INDICES, found " + quote(view.mode));
    if (!indices) refuse(fmt::format("expected a byteStride of 2 or 4 in {}, found {}", view.mode, view.stride));
    if (view.mode == "INDICES") return meshopt_decodeIndexSequence;
    if (view.count % 3 != 0)
        refuse(fmt::format("expected a count that is a multiple of 3 in TRIANGLES, found {}", view.count));
    return meshopt_decodeIndexBuffer;
}

Filter filterOf(const MeshoptData& view) {
    struct Known {
        std::string_view name;
        Filter filter;
        bool fits;  // the stride
    };
    const std::array known{
        Known{"NONE", nullptr, true},
        Known{"OCTAHEDRAL", meshopt_decodeFilterOct, view.stride == 4 || view.stride == 8},
        Known{"QUATERNION", meshopt_decodeFilterQuat, view.stride == 8},
        Known{"EXPONENTIAL", meshopt_decodeFilterExp, view.stride % 4 == 0},
    };
    for (const Known& each : known) {
        if (view.filter != each.name) continue;
        if (each.filter != nullptr && view.mode != "ATTRIBUTES")
            refuse(fmt::format("expected filter NONE in {}, found {}", view.mode, view.filter));
        if (!each.fits)
            refuse(fmt::format("expected a byteStride that filter {} takes, found {}", view.filter, view.stride));
        return each.filter;
    }
    refuse("expected filter NONE, OCTAHEDRAL, QUATERNION or EXPONENTIAL, found " + quote(view.filter));
}

void checkSize(const MeshoptData& view, std::uint64_t dataSize, std::uint64_t bytesLeft) {
    if (view.count == 0) refuse("expected a count of at least 1, found 0");
    if (view.count > bytesLeft / view.stride)
        refuse(
            fmt::format("expected at most {} bytes more in decompressed data, found {} elements of {} bytes; "
                        "raise max-decompressed-size",
                        bytesLeft, view.count, view.stride));
    if (view.count * view.stride / highestRatio > dataSize)
        refuse(fmt::format("expected compressed data of at least {} bytes for {} elements of {} bytes, found {}",
                           view.count * view.stride / highestRatio, view.count, view.stride, dataSize));
}

DecodedMeshopt decode(const MeshoptData& view, std::span<const std::uint8_t> data, std::uint64_t bytesLeft) {
    const Decode decoder = decoderOf(view);
    const Filter filter = filterOf(view);
    checkSize(view, data.size(), bytesLeft);
    std::vector<std::uint8_t> bytes(view.count * view.stride);
    if (const int failure = decoder(bytes.data(), view.count, view.stride, data.data(), data.size()); failure != 0)
        refuse(fmt::format("expected {} elements in {} bytes, found data that do not decode (error {})", view.count,
                           data.size(), failure));
    if (filter != nullptr) filter(bytes.data(), view.count, view.stride);
    return {std::move(bytes), {}};
}

}  // namespace

extern "C" INKEDGE_API const MeshoptFunctions* inkedge_meshopt_1() noexcept {
    static constexpr MeshoptFunctions functions{
        [](const MeshoptData& view, std::span<const std::uint8_t> data, std::uint64_t bytesLeft) {
            return guarded([&] { return decode(view, data, bytesLeft); });
        }};
    return &functions;
}

}  // namespace inkedge::gltf
