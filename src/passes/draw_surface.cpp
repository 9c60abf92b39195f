#include "passes/draw_surface.h"

#include <array>

#include <glm/gtc/type_ptr.hpp>

#include "gl/draw.h"
#include "passes/combine_lights.h"
#include "passes/instance_transforms.h"
#include "passes/show_tile.h"

namespace inkedge::passes {
namespace {

constexpr GLint projectionLocation = 0;
constexpr GLint unitLengthLocation = 1;

void setUniforms(gl::Gpu& gpu, gl::Program program, const glm::mat4& projection, double unit) {
    const GLuint id = gpu.programs.id(program);
    gpu.api.ProgramUniformMatrix4fv(id, projectionLocation, 1, GL_FALSE, glm::value_ptr(projection));
    gpu.api.ProgramUniform1f(id, unitLengthLocation, static_cast<float>(unit));
}

}  // namespace

SurfaceBuffers drawSurface(const Frame& frame, const DetectorSettings& settings) {
    gl::Gpu& gpu = frame.gpu;
    const Size size = frame.tile.drawn.size;
    const glm::mat4 projection{reversedProjection(frame)};
    frame.upload.setTransforms(instanceTransforms(frame, settings.lightSpace));
    gl::Texture depth = gpu.textures.acquire(size, GL_DEPTH_COMPONENT32F);

    const auto draw = [&](gl::Program program, GLenum format, const std::array<float, 4>& background) {
        gl::Texture color = gpu.textures.acquire(size, format);
        const gl::Framebuffer target{gpu.api, {&color}, &depth};
        gl::prepareDrawing(gpu, program, target);
        showTile(gpu, program, frame.tile);
        constexpr float farthest = 0.0F;
        gpu.api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 0, background.data());
        gpu.api.ClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &farthest);
        setUniforms(gpu, program, projection, frame.unit);
        frame.upload.draw(gl::UploadedScene::Triangles::All, frame.hiddenBacks);
        return color;
    };
    if (settings.normalLights == NormalLights::Single) {
        gl::Texture surface =
            draw(gl::Program::DrawSurface, GL_RGBA32F, {0.0F, 0.0F, 0.0F, static_cast<float>(frame.camera.far)});
        return {std::move(surface), std::move(depth)};
    }
    const gl::Texture positive = draw(gl::Program::DrawPositiveLights, GL_RGBA8, {});
    const gl::Texture negative = draw(gl::Program::DrawNegativeLights, GL_RGBA8, {});
    gl::Texture surface = combineLights(gpu, positive, negative, depth, frame.camera);
    return {std::move(surface), std::move(depth)};
}

}  // namespace inkedge::passes
