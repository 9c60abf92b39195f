#include "passes/composite.h"

#include "gl/draw.h"

namespace inkedge {
namespace {

void setColor(gl::Gpu& gpu, gl::Program program, GLint location, Color color, float alpha) {
    const auto channel = [](std::uint8_t value) { return static_cast<float>(value) / 255.0F; };
    gpu.api.ProgramUniform4f(gpu.programs.id(program), location, channel(color.red), channel(color.green),
                             channel(color.blue), alpha);
}

}  // namespace

gl::Texture composite(gl::Gpu& gpu, const gl::Texture& marks, const PictureSettings& settings) {
    const bool grey = settings.background && settings.background->grey() && settings.lineColor.grey();
    const gl::Program program = grey ? gl::Program::CompositeGrey : gl::Program::CompositeColor;
    gl::Texture picture = gpu.textures.acquire(marks.size(), grey ? GL_R8 : GL_RGBA8);
    setColor(gpu, program, 0, settings.lineColor, 1.0F);
    // A transparent background keeps the line's colour, so that scaling the picture later mixes in no other.
    setColor(gpu, program, 1, settings.background.value_or(settings.lineColor), settings.background ? 1.0F : 0.0F);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&picture}}, {&marks});
    return picture;
}

}  // namespace inkedge
