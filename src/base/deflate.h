#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace inkedge::base {

/// What compressed bytes begin and end with.
enum class DeflateWrapper {
    None,  ///< RFC 1951, as in entries of ZIP
    Zlib,  ///< RFC 1950, as in PNG and in blocks of OpenEXR
};

/// Compresses bytes quickly rather than well, as they come: of some input there are a few more than before.
class Deflater {
public:
    explicit Deflater(DeflateWrapper);
    ~Deflater();

    void add(std::span<const std::uint8_t> bytes);
    /// All that was added, compressed; nothing can be added after it.
    [[nodiscard]] std::vector<std::uint8_t> finish();

private:
    struct State;
    void compress(std::span<const std::uint8_t> bytes, bool last);

    std::unique_ptr<State> state_;
    std::vector<std::uint8_t> compressed_;  // its first bytes
    std::size_t size_ = 0;                  // so many
};

/// The bytes, compressed by a Deflater. Safe to call from several threads.
[[nodiscard]] std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes, DeflateWrapper);

/// The checksum that ZIP has of an entry, and PNG of a chunk.
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes) noexcept;

}  // namespace inkedge::base
