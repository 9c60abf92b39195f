#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/maps.h>

namespace inkedge::tune {

/// A map as a PNG that people see something on: the file that `inkedge render` writes, but patches and types of lines,
/// whose numbers are nearly black there, in colours.
/// @param maps  with this map
[[nodiscard]] std::vector<std::uint8_t> layerPicture(const Maps& maps, Map);

}  // namespace inkedge::tune
