#pragma once

#include <inkedge/camera.h>
#include <inkedge/scene.h>
#include <inkedge/setting_table.h>
#include <inkedge/settings.h>

namespace inkedge::render {

/// @throws Error  (Kind::Usage) if nothing can be drawn through the camera, or too little of the scene is near it
void expectUsable(const Camera&, const Scene&);
/// Coordinates and colours of a scene made of data in memory are those that it was given.
/// @throws Error  (Kind::Usage) if what is drawn reads what the scene was not loaded with
void expectLoaded(const Scene&, const RenderSettings&, const OutputKinds&);
/// @throws Error  (Kind::Runtime) if there is less memory than the picture and the maps that are asked for take
void expectMemory(const RenderSettings&);

}  // namespace inkedge::render
