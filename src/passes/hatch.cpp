#include "passes/hatch.h"

#include <glm/trigonometric.hpp>

#include "gl/draw.h"
#include "passes/plane_uniforms.h"
#include "passes/read_ink.h"

namespace inkedge::passes {

Image<std::uint8_t> hatch(const Frame& frame, const gl::Texture& planes, const StyleSettings& settings, double bend,
                          int samples) {
    gl::Gpu& gpu = frame.gpu;
    constexpr auto program = gl::Program::Hatch;
    const GLuint id = gpu.programs.id(program);
    setPlanes(frame, program);
    gpu.api.ProgramUniform1f(id, 3, static_cast<float>(glm::radians(bend)));
    gpu.api.ProgramUniform1f(id, 4, static_cast<float>(settings.hatchShade));
    gpu.api.ProgramUniform1f(id, 5, static_cast<float>(settings.hatchWidth * samples));
    const gl::Texture ink = gpu.textures.acquire(planes.size(), GL_R32F);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&ink}}, {&planes});
    return readInk(gpu.api, ink);
}

}  // namespace inkedge::passes
