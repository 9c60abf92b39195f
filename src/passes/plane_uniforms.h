#pragma once

#include "passes/frame.h"

namespace inkedge::passes {

/// Sets the uniforms of shaders/shared/planes.glsl, which take the locations 0 to 2.
inline void setPlanes(const Frame& frame, gl::Program program) {
    const gl::Api& api = frame.gpu.api;
    const GLuint id = frame.gpu.programs.id(program);
    const auto& [whole, drawn, kept] = frame.tile;
    const bool orthographic = frame.camera.orthographic();
    const glm::dvec2 focal = frame.camera.focalLengths(whole) * (orthographic ? frame.unit : 1.0);
    api.ProgramUniform2f(id, 0, static_cast<float>(focal.x), static_cast<float>(focal.y));
    api.ProgramUniform1i(id, 1, orthographic ? 1 : 0);
    const glm::dvec2 centre = frame.camera.centre(whole);
    api.ProgramUniform2f(id, 2, static_cast<float>(centre.x) - static_cast<float>(drawn.x),
                         static_cast<float>(centre.y) - static_cast<float>(drawn.y));
}

}  // namespace inkedge::passes
