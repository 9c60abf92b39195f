#include "passes/pencil.h"

#include <algorithm>
#include <cmath>

#include "base/stop.h"
#include "gl/draw.h"
#include "gl/read_back.h"
#include "raster/tiles.h"

namespace inkedge::passes {
namespace {

// The maximum displacement of a stroke: in loosenesses it is 1.5 times the two octaves of stray() in pencil.frag; and
// the pixels between which the drawing is interpolated.
int reachOf(const StyleSettings& settings) {
    return static_cast<int>(std::ceil(1.5 * 1.3 * settings.pencilLooseness)) + 1;
}

}  // namespace

Image<std::uint8_t> pencil(gl::Gpu& gpu, const Image<std::uint8_t>& drawing, const StyleSettings& settings,
                           int tileSide) {
    constexpr auto program = gl::Program::Pencil;
    const GLuint id = gpu.programs.id(program);
    gpu.api.ProgramUniform1i(id, 1, settings.pencilStrokes);
    gpu.api.ProgramUniform1f(id, 2, static_cast<float>(settings.pencilLooseness));
    gpu.api.ProgramUniform1ui(id, 3, static_cast<GLuint>(settings.pencilSeed));
    Image<std::uint8_t> picture;
    for (const raster::Tile& tile : raster::tilesOf(drawing.size(), tileSide, reachOf(settings))) {
        base::stopIfAsked();
        const gl::Texture part = gpu.textures.acquire(tile.drawn.size, GL_RGBA8);
        gl::writeBytes(gpu.api, drawing, tile.drawn, part);
        gpu.api.ProgramUniform2i(id, 0, tile.drawn.x, tile.drawn.y);
        const gl::Texture drawn = gpu.textures.acquire(tile.drawn.size, GL_RGBA8);
        gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&drawn}}, {&part});
        raster::keep(gl::readBytes(gpu.api, drawn, 4), tile, picture);
    }
    return picture;
}

}  // namespace inkedge::passes
