#pragma once

#include <inkedge/settings.h>

#include "formats/cad/model.h"

namespace inkedge::cad {

/// How fine the parts of a model are to be for settings.tolerance in settings.pictures. Parts that no picture shows
/// need be much less fine.
/// @param up       world space: the model's
/// @throws Error   (Kind::Usage) if a camera or a frame of the settings is refused
[[nodiscard]] Fineness finenessFor(const Outline&, glm::dvec3 up, const LoadSettings&);

}  // namespace inkedge::cad
