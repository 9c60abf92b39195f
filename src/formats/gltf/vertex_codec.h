#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace inkedge::gltf {

/// The first byte of vertices in version 1 of meshopt's vertex codec.
inline constexpr std::uint8_t vertexCodecVersion1 = 0xa1;

/// Decompresses vertices in version 1 of meshopt's vertex codec: KHR_meshopt_compression, appendix A, mode 0.
/// @param data    the whole stream, which starts with vertexCodecVersion1
/// @param stride  bytes of an element: 4, 8, ... 256
/// @return        count * stride bytes, element by element
/// @throws Error  (Kind::Input) if data are damaged or do not hold exactly count elements
[[nodiscard]] std::vector<std::uint8_t> decodeVertices(std::span<const std::uint8_t> data, std::size_t count,
                                                       std::size_t stride);

}  // namespace inkedge::gltf
