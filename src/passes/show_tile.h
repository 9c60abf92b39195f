#pragma once

#include "gl/gpu.h"
#include "raster/tiles.h"

namespace inkedge::passes {

/// Sets the viewport and the uniforms of shaders/shared/view.glsl, so that a target of the size of Tile::drawn shows
/// the tile. To be called after gl::prepareDrawing(), which shows a whole picture.
inline void showTile(gl::Gpu& gpu, GLuint id, const raster::Tile& tile) {
    const auto [x, y, size] = raster::viewOf(tile);
    gpu.api.Viewport(x - tile.drawn.x, y - tile.drawn.y, size.width, size.height);

    constexpr float steps = 256.0F;  // per pixel, of the grid that vertices are rounded to
    const auto half = [&](int length) { return 0.5F * steps * static_cast<float>(length); };
    gpu.api.ProgramUniform2f(id, 4, half(tile.whole.width), half(tile.whole.height));
    // y runs up in clip space, down in the picture.
    gpu.api.ProgramUniform2f(id, 5, half(2 * x + size.width - tile.whole.width),
                             -half(2 * y + size.height - tile.whole.height));
    gpu.api.ProgramUniform2f(id, 6, half(size.width), half(size.height));
}

inline void showTile(gl::Gpu& gpu, gl::Program program, const raster::Tile& tile) {
    showTile(gpu, gpu.programs.id(program), tile);
}

}  // namespace inkedge::passes
