#pragma once

#include <inkedge/camera.h>
#include <inkedge/image.h>

#include "scenes.h"

/// A view straight onto flat scenes.
namespace inkedge::flat_view {

inline constexpr Size square{128, 128};

/// A camera on +Z that shows -2..2 at 32 pixels per unit of a square; world (0, 0) lies between pixels 63 and 64.
inline Camera flatCamera() {
    Camera camera;
    camera.view = scenes::translation({0, 0, -10});
    camera.orthographicHeight = 4.0;
    camera.near = 5.0;
    camera.far = 15.0;
    return camera;
}

}  // namespace inkedge::flat_view
