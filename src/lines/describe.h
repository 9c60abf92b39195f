#pragma once

#include <inkedge/lines.h>
#include <inkedge/scene.h>

namespace inkedge::lines {

/// Fills in what makes lines complete in themselves: bounds, source and names of the scene that they were found on, and
/// an id for each, its number in their order.
/// @param space  Object or Image
void describe(Lines&, const Scene&, const RenderSettings&, LinesFrom space);

}  // namespace inkedge::lines
