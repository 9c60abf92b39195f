#pragma once

#include <glm/mat4x4.hpp>

#include "passes/frame.h"

namespace inkedge::passes {

/// What is added to clip-space z to lift something towards the eye by so many pixel footprints, which are few. It is
/// constant, because a footprint grows with depth in perspective, and is constant in an orthographic view.
/// @param projection  reversedProjection()
[[nodiscard]] inline double liftInClipSpace(const Frame& frame, const glm::dmat4& projection, double footprints) {
    const double focal = frame.camera.focalLength(frame.tile.whole);
    if (frame.camera.orthographic()) return footprints / (focal * frame.unit) * projection[2][2];
    const double lift = footprints / focal;
    return projection[3][2] * lift / (1.0 - lift);
}

}  // namespace inkedge::passes
