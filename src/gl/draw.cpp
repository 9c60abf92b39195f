#include "gl/draw.h"

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::gl {

Framebuffer::Framebuffer(const Api& api, std::initializer_list<const Texture*> colors, const Texture* depth)
    : size_{(colors.size() > 0 ? *colors.begin() : depth)->size()}, hasDepth_{depth != nullptr} {
    GLuint id = 0;
    api.CreateFramebuffers(1, &id);
    name_ = FramebufferName{api, id};
    std::vector<GLenum> buffers;
    for (const Texture* color : colors) {
        buffers.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(buffers.size()));
        api.NamedFramebufferTexture(id, buffers.back(), color->id(), 0);
    }
    if (depth != nullptr) api.NamedFramebufferTexture(id, GL_DEPTH_ATTACHMENT, depth->id(), 0);
    api.NamedFramebufferDrawBuffers(id, static_cast<GLsizei>(buffers.size()), buffers.data());
    const GLenum status = api.CheckNamedFramebufferStatus(id, GL_DRAW_FRAMEBUFFER);
    if (status != GL_FRAMEBUFFER_COMPLETE) {
        throw Error{
            Error::Kind::Runtime,
            fmt::format("expected a complete framebuffer, found status {:#x}; update the graphics driver", status)};
    }
}

void prepareDrawing(Gpu& gpu, Program program, const Framebuffer& target,
                    std::initializer_list<const Texture*> inputs) {
    prepareDrawing(gpu, gpu.programs.id(program), target, inputs);
}

void prepareDrawing(Gpu& gpu, GLuint program, const Framebuffer& target, std::initializer_list<const Texture*> inputs) {
    const Api& api = gpu.api;
    api.BindFramebuffer(GL_FRAMEBUFFER, target.id());
    api.Viewport(0, 0, target.size().width, target.size().height);
    api.DepthRange(0.0, 1.0);
    api.ClipControl(GL_UPPER_LEFT, GL_ZERO_TO_ONE);
    for (const auto off :
         {GL_SCISSOR_TEST, GL_BLEND, GL_CULL_FACE, GL_STENCIL_TEST, GL_DITHER, GL_POLYGON_OFFSET_FILL,
          GL_FRAMEBUFFER_SRGB, GL_DEPTH_CLAMP, GL_RASTERIZER_DISCARD, GL_COLOR_LOGIC_OP, GL_PRIMITIVE_RESTART,
          GL_PRIMITIVE_RESTART_FIXED_INDEX, GL_SAMPLE_MASK, GL_SAMPLE_COVERAGE, GL_SAMPLE_ALPHA_TO_COVERAGE}) {
        api.Disable(static_cast<GLenum>(off));
    }
    api.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    api.PolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    api.FrontFace(GL_CCW);
    if (target.hasDepth()) {
        api.Enable(GL_DEPTH_TEST);
        api.DepthFunc(GL_GREATER);
        api.DepthMask(GL_TRUE);
    } else {
        api.Disable(GL_DEPTH_TEST);
    }
    api.UseProgram(program);
    GLuint unit = 0;
    for (const Texture* input : inputs) {
        api.BindTextureUnit(unit, input->id());
        api.BindSampler(unit++, 0);
    }
}

void drawFullscreen(Gpu& gpu, Program program, const Framebuffer& target,
                    std::initializer_list<const Texture*> inputs) {
    prepareDrawing(gpu, program, target, inputs);
    gpu.api.BindVertexArray(gpu.emptyVertices.id());
    gpu.api.DrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace inkedge::gl
