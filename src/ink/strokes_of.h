#pragma once

#include <vector>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "ink/paint_strokes.h"

namespace inkedge {

/// Lines as strokes of pens(), so that paintStrokes() draws what linesSvg() does: the types of settings.lines, hidden
/// lines dashed, solid or not at all; a closed line's last point joins its first. Lines are cut half a width beyond the
/// edges of the picture, and simplified by less than paint shows.
[[nodiscard]] std::vector<Stroke> strokesOf(const Lines&, const PictureSettings&, const LineSettings&);

}  // namespace inkedge
