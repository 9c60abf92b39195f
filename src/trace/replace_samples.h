#pragma once

#include <span>

#include "raster/plane_pairs.h"
#include "trace/line_buffers.h"

namespace inkedge::trace {

/// The coordinates of a sample in its tile.
struct SamplePosition {
    int x;
    int y;
};

/// A sample that is to show what is seen at another one.
struct Replacement {
    SamplePosition at;
    SamplePosition from;
};

/// Replaces what samples see by what the surfaces that other samples see would show there, and finds the marks around
/// them again. Samples at the border of the tile are left as they are.
/// @param view    in the lengths of LineBuffers::planes
/// @param centre  the sample of the whole picture that the view axis meets
void replaceSamples(LineBuffers&, const raster::PlaneView& view, glm::dvec2 centre, std::span<const Replacement>);

}  // namespace inkedge::trace
