#pragma once

#include <inkedge/settings.h>

#include "gl/gpu.h"

namespace inkedge {

/// The outline picture: the line colour where a mark is not 0, the background elsewhere.
/// Returns R8 if both colours are grey and the background is opaque, else RGBA8 (alpha 0 on a transparent background).
/// Shader: composite.frag.
[[nodiscard]] gl::Texture composite(gl::Gpu&, const gl::Texture& marks, const PictureSettings&);

}  // namespace inkedge
