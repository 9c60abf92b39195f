#pragma once

#include <string>

#include "io/drawing.h"

namespace inkedge::io {

/// A drawing as a DXF of the year 2000: polylines in millimetres, y up, the page's lower left corner at 0, 0. Arcs are
/// exact, curves are polylines that stray from them by a twentieth of a pixel. Layers of one name are one layer.
/// @param pixel  millimetres that a pixel is wide: of the page, or of the model
[[nodiscard]] std::string dxfOf(const Drawing&, double pixel);

}  // namespace inkedge::io
