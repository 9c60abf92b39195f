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

/// Removes the temporary files of every write under way in this process; those writes then fail. For the handler of a
/// signal that ends the process: async-signal-safe, to be followed by _exit().
INKEDGE_API void removeTemporaryFiles() noexcept;

}  // namespace inkedge
