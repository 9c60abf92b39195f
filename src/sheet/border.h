#pragma once

#include <inkedge/sheet.h>

#include "io/drawing.h"

namespace inkedge::sheet {

/// The frame, centring marks, and the marks and names of fields by which a part of the drawing is found: ISO 5457.
[[nodiscard]] io::Layer borderLayer(const SheetPage&);

}  // namespace inkedge::sheet
