#pragma once

#include <string>

#include "io/drawing.h"

namespace inkedge::io {

/// A drawing as an SVG document: one group a layer, a layer of Inkscape's, too, and in it a path or, where one would be
/// too long for readers, several.
[[nodiscard]] std::string svgOf(const Drawing&);

}  // namespace inkedge::io
