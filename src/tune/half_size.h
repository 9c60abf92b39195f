#pragma once

#include <inkedge/settings.h>

namespace inkedge::tune {

/// Settings of the same drawing on half as many pixels along each axis: lengths in pixels are half as long, those in
/// millimetres are drawn at half the dpi. Nothing becomes shorter than its setting takes.
[[nodiscard]] Settings halfSize(Settings);

}  // namespace inkedge::tune
