#pragma once

#include <inkedge/camera.h>

#include "trace/line_buffers.h"

namespace inkedge::trace {

/// Removes the marks of pinholes. Vertices that nearly touch leave cracks, through which single samples see what lies
/// behind. A sample is a pinhole if its four neighbours share a surface in front of it that goes on from each neighbour
/// to the opposite one.
/// @param unit  scene units in a unit length of the planes
void removePinholes(LineBuffers&, const Camera&, double unit);

}  // namespace inkedge::trace
