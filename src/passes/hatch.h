#pragma once

#include <inkedge/camera.h>
#include <inkedge/settings.h>

#include "gl/gpu.h"
#include "raster/tiles.h"

namespace inkedge {

/// Hatch marks where facets bend: how much of each sample is covered, 0 to 255. Shader: hatch.frag; CPU definition:
/// reference::hatch().
/// @param planes    as PlaneBuffers::planes, of this tile; left unchanged
/// @param unit      scene units in a unit length of the planes
/// @param settings  whose hatchBend is given
/// @param samples   of a pixel, along each axis
[[nodiscard]] Image<std::uint8_t> hatch(gl::Gpu&, const gl::Texture& planes, const Tile&, const Camera&, double unit,
                                        const StyleSettings&, int samples);

}  // namespace inkedge
