#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace inkedge::base {

/// What compressed bytes begin and end with.
enum class DeflateWrapper {
    None,  ///< RFC 1951, as in entries of ZIP
    Zlib,  ///< RFC 1950, as in PNG and in blocks of OpenEXR
};

/// The bytes, compressed quickly rather than well; of some input they are a few more than before. Safe to call from
/// several threads.
[[nodiscard]] std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, DeflateWrapper);

/// The checksum that ZIP has of an entry, and PNG of a chunk.
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace inkedge::base
