#pragma once

#include <vector>

#include "trace/line_buffers.h"
#include "trace/replace_samples.h"
#include "trace/screen_triangles.h"

namespace inkedge::trace {

/// Finds slivers: single samples that see a surface through a gap, or on a strip, of a fiftieth of a sample. Whether a
/// sample sees such a strip depends on how positions are rounded (T-junctions, edges of faces that touch). It is to
/// show the surface beside the strip.
[[nodiscard]] std::vector<Replacement> findSlivers(const LineBuffers&, const ScreenTriangles&);

}  // namespace inkedge::trace
