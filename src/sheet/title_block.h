#pragma once

#include <vector>

#include <inkedge/sheet.h>

#include "io/drawing.h"

namespace inkedge::sheet {

/// The title block: title, file, date, scale, page and the symbol of the projection. ISO 7200.
[[nodiscard]] std::vector<io::Layer> titleBlockLayers(const Sheet&);

/// The title that is written: the one that is set, or the model's name.
[[nodiscard]] std::string titleOf(const Sheet&);

/// What of the title block cannot be written as it is, one line each.
[[nodiscard]] std::vector<std::string> titleBlockWarnings(const Sheet&);

}  // namespace inkedge::sheet
