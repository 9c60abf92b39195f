#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Tars as POSIX.1-2001 has them (pax), without what differs from run to run: owners, times.
namespace inkedge::batch {

inline constexpr std::size_t tarBlock = 512;  // bytes

/// What stands before a member's bytes.
/// @param name  UTF-8
[[nodiscard]] std::vector<std::uint8_t> tarHeader(std::string_view name, std::uint64_t size);
/// What stands after them.
[[nodiscard]] std::span<const std::uint8_t> tarPadding(std::uint64_t size) noexcept;
/// What stands after the last member.
[[nodiscard]] std::span<const std::uint8_t> tarEnd() noexcept;

/// A member where it lies in a tar.
struct TarMember {
    std::string name;
    std::uint64_t begin = 0;  ///< of its headers, bytes
    std::uint64_t end = 0;    ///< of its padding
};

/// The members of a tar that was made here, in their order; none of one that was not.
/// @param descriptor  of the file; read by position
[[nodiscard]] std::vector<TarMember> tarMembers(int descriptor);

}  // namespace inkedge::batch
