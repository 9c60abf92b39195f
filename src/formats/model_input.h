#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "base/read_file.h"

namespace inkedge::formats {

/// A model to be read: a file, or bytes in memory, which have no folder that other files could lie in.
struct ModelInput {
    std::filesystem::path name;  ///< the file; of bytes: what their file would be called, or empty
    std::optional<std::span<const std::uint8_t>> bytes = {};  ///< in memory; none: the file's

    [[nodiscard]] bool isFile() const noexcept { return !bytes; }
    /// What messages about it start with.
    [[nodiscard]] std::string where() const;
};

/// The first bytes, at most size.
/// @throws Error  (Kind::Input) if there are none, or the file is missing, unreadable or no regular file
[[nodiscard]] base::Bytes startOf(const ModelInput&, std::size_t size);

/// All bytes of a model: its file, read whole, or those in memory, which are not copied and must outlive it.
class Content {
public:
    /// Takes the size off bytesLeft.
    /// @throws Error  (Kind::Input) as startOf(), or if there are more than bytesLeft
    Content(const ModelInput&, std::uint64_t& bytesLeft);

    [[nodiscard]] std::span<const std::uint8_t> bytes() const noexcept { return bytes_; }
    /// A part of bytes() by itself; of a file the rest is let go before.
    [[nodiscard]] base::Bytes keepOnly(std::span<const std::uint8_t> part) &&;

private:
    base::Bytes read_;  // of a file
    std::span<const std::uint8_t> bytes_;
};

}  // namespace inkedge::formats
