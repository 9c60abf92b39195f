#pragma once

#include <inkedge/camera.h>

#include "trace/line_buffers.h"
#include "trace/screen_triangles.h"

namespace inkedge::trace {

/// Removes slivers: single samples that see a surface through a gap, or on a strip, of a fiftieth of a sample. Whether
/// a sample sees such a strip depends on how positions are rounded (T-junctions, edges of faces that touch). It then
/// counts as seeing the surface beside the strip.
/// @param unit  scene units in a unit length of the planes
void removeSlivers(LineBuffers&, const ScreenTriangles&, const Camera&, double unit, double creaseAngle);

}  // namespace inkedge::trace
