#pragma once

#include <inkedge/bounds.h>
#include <inkedge/camera.h>

namespace inkedge::camera {

/// Of the picture's width or height: what a framed model fills at most.
inline constexpr double frameShare = 0.92;

/// Fits the near and far planes of a camera to a sphere around all that is drawn.
void fitNearAndFar(Camera&, const Sphere& bounds);

}  // namespace inkedge::camera
