#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/lines.h>
#include <inkedge/scene.h>

#include "lines/screen.h"
#include "scene/scene_face.h"

namespace inkedge::lines {

/// A straight piece of a line that was traced in the picture.
struct TracedPiece {
    std::array<glm::vec2, 2> pixels;     ///< output pixels; pieces that are joined have one in common, to the last bit
    std::array<double, 2> inverseDepth;  ///< of the surface that the piece lies on: ScreenPoint::inverseDepth
    LineType type;
    SceneFace face;  ///< that the piece lies on
};

/// Joins pieces to polylines of one type and node each: section 2.2 of Hertzmann 1999. Junctions and gaps are treated
/// as for lines from object space.
[[nodiscard]] std::vector<Line> joinPieces(std::span<const TracedPiece>, const Scene&, const Screen&);

}  // namespace inkedge::lines
