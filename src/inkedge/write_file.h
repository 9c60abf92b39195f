#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include <inkedge/export.h>

namespace inkedge {

/// Writes bytes to a file by way of a temporary one in the same folder, which has no name where the file system can do
/// so: it appears whole or not at all, however the process ends.
/// @throws Error  (Kind::Output) with the system's reason
INKEDGE_API void writeFile(const std::filesystem::path&, std::span<const std::uint8_t>);

}  // namespace inkedge
