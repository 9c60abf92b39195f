#include "passes/detect_profiles.h"

#include "gl/draw.h"
#include "passes/read_ink.h"

namespace inkedge::passes {

Image<std::uint8_t> detectProfiles(const Frame& frame, const gl::Texture& surface, const DetectorSettings& settings) {
    constexpr auto program = gl::Program::DetectProfiles;
    gl::Gpu& gpu = frame.gpu;
    const GLuint id = gpu.programs.id(program);
    gpu.api.ProgramUniform1f(id, 0, static_cast<float>(frame.camera.focalLength(frame.tile.whole)));
    gpu.api.ProgramUniform1i(id, 1, frame.camera.orthographic() ? 1 : 0);
    gpu.api.ProgramUniform1f(id, 2, static_cast<float>(settings.profileLimit));
    gpu.api.ProgramUniform1f(id, 3, static_cast<float>(settings.edgeLimit));
    const gl::Texture darkness = gpu.textures.acquire(surface.size(), GL_R32F);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&darkness}}, {&surface});
    return readInk(gpu.api, darkness);
}

}  // namespace inkedge::passes
