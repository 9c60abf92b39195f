#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace inkedge::base {

/// Distinguishes contents by 128 bits: the same on every machine, but no proof against those who forge it.
/// MurmurHash3 (x64, 128 bits) by Austin Appleby.
class ContentHash {
public:
    void add(std::span<const std::uint8_t> bytes) noexcept;
    /// With its length, so that texts one after the other differ from the same put together otherwise.
    void add(std::string_view text) noexcept;

    using Value = std::array<std::uint64_t, 2>;
    [[nodiscard]] Value value() const noexcept;
    [[nodiscard]] std::string hex() const;  ///< 32 digits

private:
    void mix(std::uint64_t k1, std::uint64_t k2) noexcept;

    Value state_{};
    std::array<std::uint8_t, 16> rest_{};  // what does not fill a block yet
    std::uint64_t size_ = 0;
};

/// Of a text.
[[nodiscard]] std::uint64_t hashOf(std::string_view text) noexcept;

/// Of a file's bytes; none if it cannot be read.
[[nodiscard]] std::optional<std::string> hashOfFile(const std::filesystem::path&);

}  // namespace inkedge::base
