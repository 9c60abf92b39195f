#pragma once

#include <inkedge/sheet.h>

#include "sheet/ink.h"

namespace inkedge::sheet {

/// The symbol of ISO 5456-2: a truncated cone from the side and from its narrower end, arranged as the views are.
/// @param height  of letters beside it
void drawSymbol(Ink&, Projection, glm::dvec2 middle, double height);

}  // namespace inkedge::sheet
