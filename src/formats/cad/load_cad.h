#pragma once

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "formats/model_input.h"

namespace inkedge::cad {

/// Reads STEP, by ISO 10303-21, of AP203, AP214 or AP242: all solids and faces of all roots, in millimetres. Parts that
/// stand several times in an assembly are one mesh. The triangles of curved faces are as fine as settings.tolerance and
/// settings.pictures ask for.
/// @throws Error  (Kind::Input) if it is no such file, is cut short, or the library cannot read it within the limits,
///                crashes over it among them; (Kind::Usage) if a camera of the settings is refused
[[nodiscard]] Scene::Data loadStep(const formats::ModelInput&, const LoadSettings&);
/// Likewise IGES. Faces that lie beside each other are joined.
[[nodiscard]] Scene::Data loadIges(const formats::ModelInput&, const LoadSettings&);
/// Likewise OpenCASCADE's own BREP, as text or binary.
[[nodiscard]] Scene::Data loadBrep(const formats::ModelInput&, const LoadSettings&);
/// Likewise 3MF, the core, materials and production specifications: what its items build. Colours are materials.
[[nodiscard]] Scene::Data loadThreeMf(const formats::ModelInput&, const LoadSettings&);

}  // namespace inkedge::cad
