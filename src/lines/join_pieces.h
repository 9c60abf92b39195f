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

/// A piece of a line as it was traced in the picture.
struct TracedPiece {
    std::array<glm::vec2, 2> places;  ///< output pixels; pieces that go on into each other share one to the last bit
    std::array<double, 2> nearness;   ///< of the surface that it lies on, as ScreenPoint has it
    LineType type;
    SceneFace face;  ///< that it lies on
};

/// Joins pieces to polylines, one per type and node: section 2.2 of Hertzmann 1999. Junctions and gaps are treated as
/// those of lines from object space are.
[[nodiscard]] std::vector<Line> joinPieces(std::span<const TracedPiece>, const Scene&, const Screen&);

}  // namespace inkedge::lines
