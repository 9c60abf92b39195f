#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <vector>

#include <inkedge/lines.h>
#include <inkedge/maps.h>
#include <inkedge/settings.h>

namespace inkedge::io {

/// Takes the bytes of a file, which are there during the call only.
using TakeFile = std::function<void(const std::filesystem::path&, std::span<const std::uint8_t>)>;

/// The files that writeMaps() writes, one after the other; their names are given.
/// @param files    as many as outputFiles() gives for these maps, and in its order
/// @throws Error   as writeMaps(); what take throws
void encodeMaps(const Maps&, std::span<const Map> maps, std::span<const std::filesystem::path> files,
                const TakeFile& take);

/// The file that writeLines() writes.
/// @throws Error  (Kind::Usage, Kind::Output) as writeLines()
[[nodiscard]] std::vector<std::uint8_t> encodeLines(const Lines&, const Settings&, const std::filesystem::path& file);

}  // namespace inkedge::io
