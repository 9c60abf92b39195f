#pragma once

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "formats/model_input.h"

namespace inkedge::implicit {

/// Reads an implicit surface: a text of lines,
///
///     # a ball
///     bounds -1.2 -1.2 -1.2  1.2 1.2 1.2
///     unit mm
///     f = x^2 + y^2 + z^2 - 1
///
/// of the least and the greatest x, y and z, perhaps a unit, and an expression, which goes on in lines that start with
/// a blank. The surface is where it is 0; its triangles are as fine as settings.tolerance and settings.pictures ask
/// for.
/// @throws Error  (Kind::Input) if a line is none of these, or the expression is none, not finite somewhere within the
///                bounds, or 0 nowhere; (Kind::Usage) if a camera of the settings is refused
[[nodiscard]] Scene::Data loadImplicit(const formats::ModelInput&, const LoadSettings&);

}  // namespace inkedge::implicit
