#pragma once

#include <filesystem>
#include <span>

#include <inkedge/maps.h>
#include <inkedge/settings.h>

namespace inkedge::io {

/// What writeMaps() does, to files whose names are given.
/// @param files    as many as outputFiles() gives for these maps, and in its order
/// @throws Error   as writeMaps()
void writeMapFiles(const Maps&, std::span<const Map> maps, std::span<const std::filesystem::path> files);

}  // namespace inkedge::io
