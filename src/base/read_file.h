#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace inkedge::base {

using Bytes = std::vector<std::uint8_t>;

/// Reads a whole file and subtracts its size from bytesLeft.
/// @throws Error  (Kind::Input) if it is missing, empty, unreadable, no regular file or larger than bytesLeft
[[nodiscard]] Bytes readBytes(const std::filesystem::path&, std::uint64_t& bytesLeft);

/// Subtracts a size from bytesLeft.
/// @throws Error  (Kind::Input) if it is larger
void spend(std::uint64_t size, std::uint64_t& bytesLeft);

/// The first bytes of a file, at most size.
/// @throws Error  (Kind::Input) if it is missing, empty, unreadable or no regular file
[[nodiscard]] Bytes readStart(const std::filesystem::path&, std::size_t size);

[[nodiscard]] std::string_view textOf(std::span<const std::uint8_t> bytes) noexcept;

/// What a file seems to be by its first bytes, in words: "a PNG picture", "other text".
[[nodiscard]] std::string_view kindOf(std::string_view content) noexcept;

}  // namespace inkedge::base
