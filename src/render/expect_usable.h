#pragma once

#include <inkedge/camera.h>
#include <inkedge/settings.h>

namespace inkedge {

/// @throws Error  (Kind::Usage) if nothing can be drawn through it
void expectUsable(const Camera&);
/// @throws Error  (Kind::Runtime) if there is less memory than the picture and the maps that are asked for take
void expectMemory(const RenderSettings&);

}  // namespace inkedge
