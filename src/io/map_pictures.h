#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include <inkedge/camera.h>
#include <inkedge/maps.h>

#include "io/map_layers.h"

namespace inkedge::io {

/// Depth that a step of the grey levels of a depth map in a PNG stands for; the first level is Camera::near.
[[nodiscard]] inline double depthScale(const Camera& camera) noexcept { return (camera.far - camera.near) / 65535.0; }

/// A layer as a PNG: depth as 16 bits of grey from near (0) to far (65535), types and ids as 16 bits of grey, normals
/// as (n + 1) / 2 of 8 bits, edges black on white, the shade as it is; the file tells Maps::dpi.
/// @throws Error  (Kind::Output) if an id is over 65535
[[nodiscard]] std::vector<std::uint8_t> pngOf(const Maps&, const MapLayer&, const std::filesystem::path& target);

/// A layer as a TIFF of floats, values as in an EXR; the shade as 8 bits of sRGB.
/// @param dpi     pixels per inch, if the file is to tell them
/// @throws Error  (Kind::Output) if an id is over 16777216, or it cannot be encoded
[[nodiscard]] std::vector<std::uint8_t> tiffOf(const MapLayer&, std::optional<double> dpi,
                                               const std::filesystem::path& target);

}  // namespace inkedge::io
