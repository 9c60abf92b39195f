#pragma once

#include <initializer_list>

#include <inkedge/maps.h>
#include <inkedge/settings.h>

#include "passes/detect_edges.h"
#include "passes/draw_surface.h"

namespace inkedge {

[[nodiscard]] bool wants(const RenderSettings&, Map);
[[nodiscard]] bool wantsAny(const RenderSettings&, std::initializer_list<Map>);

/// Fills depth, windowDepth and normal, as far as they are wanted.
void readSurface(const gl::Api&, const SurfaceBuffers&, const RenderSettings&, Maps&);

/// Fills the edge masks and magnitudes, as far as they are wanted.
void readEdges(const gl::Api&, const EdgeBuffers&, const RenderSettings&, Maps&);

/// 255 where a pixel has any of the types, else 0.
/// @param types  as Maps::types
[[nodiscard]] Image<std::uint8_t> mask(const Image<std::uint16_t>& types, LineTypes wanted);

}  // namespace inkedge
