#pragma once

namespace inkedge::raster {

/// Bits of the edges between a sample and its neighbour. shaders/shared/marks.glsl has the same.
struct PairMark {
    static constexpr unsigned background = 1;  ///< one of the two sees no surface
    static constexpr unsigned patch = 2;       ///< the patches differ
    static constexpr unsigned bend = 4;        ///< the faces bend by more than the crease angle
    static constexpr unsigned jump = 8;        ///< one surface lies in front of the other
};

}  // namespace inkedge::raster
