#pragma once

#include <inkedge/lines.h>
#include <inkedge/maps.h>

namespace inkedge::render {

/// Adds the lines of lines::typesAddedToMaps that are seen to Maps::types, at the pixels that they pass through, and to
/// Maps::edges; to those of the two that are there.
/// @param drawn  PictureSettings::lines
void mapBeside(const Lines&, LineTypes drawn, Maps&);

}  // namespace inkedge::render
