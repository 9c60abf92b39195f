#pragma once

#include <inkedge/camera.h>

#include "gl/gpu.h"

namespace inkedge {

/// Sets the struct of shaders/shared/depth.glsl, which takes three locations.
inline void setDepths(gl::Gpu& gpu, gl::Program program, GLint location, const Camera& camera) {
    const GLuint id = gpu.programs.id(program);
    gpu.api.ProgramUniform1f(id, location, static_cast<float>(camera.near));
    gpu.api.ProgramUniform1f(id, location + 1, static_cast<float>(camera.far));
    gpu.api.ProgramUniform1i(id, location + 2, camera.orthographic() ? 1 : 0);
}

}  // namespace inkedge
