#pragma once

#include <array>

#include <glm/vec2.hpp>

#include <inkedge/line_types.h>

#include "scene/scene_face.h"

namespace inkedge::trace {

/// A piece of a line as it was traced between samples.
struct TracedPiece {
    /// Output pixels of the whole picture. Pieces that go on into each other share an end to the last bit.
    std::array<glm::vec2, 2> ends;
    /// At the ends, of the surface that it lies on: 1 / depth, or -depth in orthographic views.
    std::array<float, 2> inverseDepths;
    LineType type = LineType::Outline;
    scene::SceneFace face;  ///< that it lies on: the nearer one
    float width = 1.0F;     ///< share of its pen's: under 1 for parts thinner than a pixel
};

}  // namespace inkedge::trace
