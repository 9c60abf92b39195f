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

}  // namespace inkedge::trace
