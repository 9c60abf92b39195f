#pragma once

#include <inkedge/image.h>
#include <inkedge/settings.h>

#include "passes/frame.h"

namespace inkedge::passes {

/// Hatch marks where facets bend: how much of each sample is covered, 0 to 255. Shader: hatch.frag; CPU definition:
/// reference::hatch().
/// @param frame    in samples
/// @param planes   as PlaneBuffers::planes, of this frame; left unchanged
/// @param bend     StyleSettings::hatchBend in force, degrees
/// @param samples  of a pixel, along each axis
[[nodiscard]] Image<std::uint8_t> hatch(const Frame& frame, const gl::Texture& planes, const StyleSettings&,
                                        double bend, int samples);

}  // namespace inkedge::passes
