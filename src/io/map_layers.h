#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <inkedge/maps.h>
#include <inkedge/settings.h>

#include "images/layer.h"

namespace inkedge::io {

/// Names of the channels of Maps::ids, in their order.
inline constexpr std::array<std::string_view, 4> idNames{"patch", "across", "object", "material"};

/// A map, or one channel of the ids: what one file holds where a format has one map a file.
struct MapLayer {
    Map map;
    std::string file;      ///< its name in names of files: "depth", "ids-object"
    images::Layer values;  ///< channels named as in an EXR: "depth.Z", "object.V"
};

/// The layers of a map; the images are the maps', or empty if it was not rendered.
[[nodiscard]] std::vector<MapLayer> layersOf(const Maps&, Map);

/// MapLayer::file of each of them.
[[nodiscard]] std::vector<std::string> layerFiles(Map);

/// The name of a map among arrays: "depth_edges".
[[nodiscard]] std::string arrayName(Map);

/// With all below it exact as a float.
inline constexpr std::uint32_t maxExactFloat = 1U << 24U;

/// @param max      the largest number that the file holds
/// @param because  "which the floats of an EXR hold exactly"
/// @throws Error   (Kind::Output) if there is a larger one among the ids; the message begins with the file's name
void expectIdsUpTo(std::uint32_t max, std::string_view because, const MapLayer&, const std::filesystem::path& target);

}  // namespace inkedge::io
