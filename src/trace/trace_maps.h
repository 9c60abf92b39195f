#pragma once

#include <cstdint>

#include <inkedge/image.h>
#include <inkedge/scene.h>

#include "trace/line_buffers.h"
#include "trace/screen_triangles.h"

namespace inkedge::trace {

/// The patch, the patch across, the node and the material of each sample, as Maps::ids; 0 where the tile does not keep
/// it.
[[nodiscard]] Image<std::uint32_t> traceIds(const LineBuffers&, const Scene&, const ScreenTriangles&);

/// Maps::types of pixels: those of all their samples.
[[nodiscard]] Image<std::uint16_t> typesOfPixels(const Image<std::uint16_t>& samples, int samplesPerPixel);

/// Maps::ids of pixels: those of the first sample of each that lies beside a line, or else of its middle one.
/// @param ids, types  of the samples
[[nodiscard]] Image<std::uint32_t> idsOfPixels(const Image<std::uint32_t>& ids, const Image<std::uint16_t>& types,
                                               int samplesPerPixel);

}  // namespace inkedge::trace
