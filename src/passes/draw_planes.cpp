#include "passes/draw_planes.h"

#include <array>

#include <glm/gtc/type_ptr.hpp>

#include "gl/draw.h"
#include "passes/instance_transforms.h"
#include "passes/lift.h"
#include "passes/show_tile.h"

namespace inkedge::passes {
namespace {

// How far layers are lifted towards the eye, in pixel footprints: more than the rounding of the depth test between
// faces in one plane, and less than any step that can be seen.
constexpr double layerLift = 0.05;

void setUniforms(const Frame& frame, gl::Program program, const glm::mat4& projection, double lift) {
    const GLuint id = frame.gpu.programs.id(program);
    frame.gpu.api.ProgramUniformMatrix4fv(id, 0, 1, GL_FALSE, glm::value_ptr(projection));
    frame.gpu.api.ProgramUniform1f(id, 1, static_cast<float>(lift));
    frame.gpu.api.ProgramUniform1i(id, 2, frame.camera.orthographic() ? 1 : 0);
}

// Clears the target that prepareDrawing() has set, and draws the scene.
void drawScene(const Frame& frame, gl::Program program, const gl::Framebuffer& target, const glm::dmat4& projection) {
    constexpr float zeros[4]{};
    constexpr GLuint noTriangle[4]{};
    const gl::Api& api = frame.gpu.api;
    api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 0, zeros);
    api.ClearNamedFramebufferuiv(target.id(), GL_COLOR, 1, noTriangle);
    api.ClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, zeros);
    setUniforms(frame, program, glm::mat4{projection}, 0.0);
    frame.upload.draw(gl::UploadedScene::Triangles::All, frame.hiddenBacks);
}

// Adds the numbers of coplanar layers to the planes that are drawn.
void drawLayers(const Frame& frame, const gl::Texture& planes, const gl::Texture& depth, const glm::dmat4& projection) {
    if (!frame.upload.hasLayers()) return;
    const gl::Api& api = frame.gpu.api;
    const gl::Framebuffer target{api, {&planes}, &depth};
    gl::prepareDrawing(frame.gpu, gl::Program::DrawLayers, target);
    showTile(frame.gpu, gl::Program::DrawLayers, frame.tile);
    api.DepthFunc(GL_GEQUAL);
    api.DepthMask(GL_FALSE);
    api.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    api.Enable(GL_BLEND);
    api.BlendEquation(GL_FUNC_ADD);
    api.BlendFunc(GL_ONE, GL_ONE);
    setUniforms(frame, gl::Program::DrawLayers, glm::mat4{projection}, liftInClipSpace(frame, projection, layerLift));
    frame.upload.draw(gl::UploadedScene::Triangles::Layers, frame.hiddenBacks);
}

}  // namespace

PlaneBuffers drawPlanes(const Frame& frame) {
    gl::Gpu& gpu = frame.gpu;
    const Size size = frame.tile.drawn.size;
    const glm::dmat4 projection = reversedProjection(frame);
    frame.upload.setTransforms(instanceTransforms(frame, LightSpace::Camera));

    PlaneBuffers buffers{gpu.textures.acquire(size, GL_RGBA32F), gpu.textures.acquire(size, GL_R32UI)};
    const gl::Texture depth = gpu.textures.acquire(size, GL_DEPTH_COMPONENT32F);
    const gl::Framebuffer target{gpu.api, {&buffers.planes, &buffers.triangles}, &depth};
    gl::prepareDrawing(gpu, gl::Program::DrawPlanes, target);
    showTile(gpu, gl::Program::DrawPlanes, frame.tile);
    drawScene(frame, gl::Program::DrawPlanes, target, projection);
    drawLayers(frame, buffers.planes, depth, projection);
    return buffers;
}

PlanesAndSurface drawPlanesAndSurface(const Frame& frame, LightSpace lightSpace) {
    constexpr auto program = gl::Program::DrawPlanesAndSurface;
    gl::Gpu& gpu = frame.gpu;
    const Size size = frame.tile.drawn.size;
    const glm::dmat4 projection = reversedProjection(frame);
    frame.upload.setTransforms(instanceTransforms(frame, lightSpace));

    PlanesAndSurface buffers{
        {gpu.textures.acquire(size, GL_RGBA32F), gpu.textures.acquire(size, GL_R32UI)},
        {gpu.textures.acquire(size, GL_RGBA32F), gpu.textures.acquire(size, GL_DEPTH_COMPONENT32F)}};
    auto& [planes, surface] = buffers;
    const gl::Framebuffer target{gpu.api, {&planes.planes, &planes.triangles, &surface.surface}, &surface.depth};
    gl::prepareDrawing(gpu, program, target);
    showTile(gpu, program, frame.tile);
    const std::array background{0.0F, 0.0F, 0.0F, static_cast<float>(frame.camera.far)};
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 2, background.data());
    gpu.api.ProgramUniform1f(gpu.programs.id(program), 3, static_cast<float>(frame.unit));
    drawScene(frame, program, target, projection);
    drawLayers(frame, planes.planes, surface.depth, projection);
    return buffers;
}

}  // namespace inkedge::passes
