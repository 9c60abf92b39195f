#pragma once

#include <inkedge/camera.h>

#include "gl/gpu.h"
#include "raster/tiles.h"

namespace inkedge {

/// Sets the uniforms of shaders/shared/planes.glsl, which take the locations 0 to 2.
/// @param unit  scene units in a unit length of the planes
inline void setPlanes(gl::Gpu& gpu, gl::Program program, const Tile& tile, const Camera& camera, double unit) {
    const GLuint id = gpu.programs.id(program);
    const double focal = camera.focalLength(tile.whole) * (camera.orthographic() ? unit : 1.0);
    gpu.api.ProgramUniform1f(id, 0, static_cast<float>(focal));
    gpu.api.ProgramUniform1i(id, 1, camera.orthographic() ? 1 : 0);
    gpu.api.ProgramUniform2f(id, 2, 0.5F * static_cast<float>(tile.whole.width) - static_cast<float>(tile.drawn.x),
                             0.5F * static_cast<float>(tile.whole.height) - static_cast<float>(tile.drawn.y));
}

}  // namespace inkedge
