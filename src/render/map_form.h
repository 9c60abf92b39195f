#pragma once

#include <inkedge/lines.h>
#include <inkedge/maps.h>

namespace inkedge::render {

/// Adds the lines of form that are seen to Maps::types, at the pixels that they pass through, and to Maps::edges; to
/// those of the two that are there.
/// @param drawn  PictureSettings::lines
void mapForm(const Lines&, LineTypes drawn, Maps&);

}  // namespace inkedge::render
