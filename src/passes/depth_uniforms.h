#pragma once

#include <inkedge/camera.h>

#include "gl/gpu.h"

namespace inkedge::passes {

/// Sets the struct of shaders/shared/depth.glsl, which takes three locations.
inline void setDepths(gl::Gpu& gpu, GLuint id, GLint location, const Camera& camera) {
    gpu.api.ProgramUniform1f(id, location, static_cast<float>(camera.near));
    gpu.api.ProgramUniform1f(id, location + 1, static_cast<float>(camera.far));
    gpu.api.ProgramUniform1i(id, location + 2, camera.orthographic() ? 1 : 0);
}

inline void setDepths(gl::Gpu& gpu, gl::Program program, GLint location, const Camera& camera) {
    setDepths(gpu, gpu.programs.id(program), location, camera);
}

}  // namespace inkedge::passes
