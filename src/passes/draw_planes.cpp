#include "passes/draw_planes.h"

#include <array>

#include <glm/gtc/type_ptr.hpp>

#include "gl/draw.h"
#include "passes/placement.h"
#include "passes/show_tile.h"

namespace inkedge {
namespace {

// How far layers are lifted towards the eye, in pixel footprints: over what the depth test's rounding leaves between
// faces in one plane, and less than any step that shows.
constexpr double layerLift = 0.05;

// Clip-space z of points that much nearer to the eye, less that of the points themselves: constant, because a footprint
// grows with depth in perspective and not at all in an orthographic view.
double liftInClipSpace(const glm::dmat4& projection, const Camera& camera, Size size, double unit) {
    if (camera.orthographic()) return layerLift / (camera.focalLength(size) * unit) * projection[2][2];
    const double lift = layerLift / camera.focalLength(size);
    return projection[3][2] * lift / (1.0 - lift);
}

void setUniforms(gl::Gpu& gpu, gl::Program program, const glm::mat4& projection, double lift, bool orthographic) {
    const GLuint id = gpu.programs.id(program);
    gpu.api.ProgramUniformMatrix4fv(id, 0, 1, GL_FALSE, glm::value_ptr(projection));
    gpu.api.ProgramUniform1f(id, 1, static_cast<float>(lift));
    gpu.api.ProgramUniform1i(id, 2, orthographic ? 1 : 0);
}

// Draws the scene into what prepareDrawing() has set, cleared.
void drawScene(gl::Gpu& gpu, gl::Program program, const gl::UploadedScene& upload, const gl::Framebuffer& target,
               const glm::dmat4& projection, const Camera& camera, gl::UploadedScene::HiddenBacks backs) {
    constexpr float zeros[4]{};
    constexpr GLuint noTriangle[4]{};
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 0, zeros);
    gpu.api.ClearNamedFramebufferuiv(target.id(), GL_COLOR, 1, noTriangle);
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, zeros);
    setUniforms(gpu, program, glm::mat4{projection}, 0.0, camera.orthographic());
    upload.draw(gl::UploadedScene::Part::All, backs);
}

// Adds the numbers of coplanar layers to the planes that are drawn.
void drawLayers(gl::Gpu& gpu, const gl::UploadedScene& upload, const gl::Texture& planes, const gl::Texture& depth,
                const glm::dmat4& projection, const Tile& tile, const Camera& camera, double unit,
                gl::UploadedScene::HiddenBacks backs) {
    if (!upload.hasLayers()) return;
    const gl::Framebuffer target{gpu.api, {&planes}, &depth};
    gl::prepareDrawing(gpu, gl::Program::DrawLayers, target);
    showTile(gpu, gl::Program::DrawLayers, tile);
    gpu.api.DepthFunc(GL_GEQUAL);
    gpu.api.DepthMask(GL_FALSE);
    gpu.api.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gpu.api.Enable(GL_BLEND);
    gpu.api.BlendEquation(GL_FUNC_ADD);
    gpu.api.BlendFunc(GL_ONE, GL_ONE);
    setUniforms(gpu, gl::Program::DrawLayers, glm::mat4{projection},
                liftInClipSpace(projection, camera, tile.whole, unit), camera.orthographic());
    upload.draw(gl::UploadedScene::Part::Layers, backs);
}

}  // namespace

PlaneBuffers drawPlanes(gl::Gpu& gpu, const gl::UploadedScene& upload, const Scene& scene, const Camera& camera,
                        const Tile& tile) {
    const Size size = tile.drawn.size;
    const double unit = unitLength(scene);
    const glm::dmat4 projection = reversedProjection(camera, tile.whole, unit);
    upload.place(placeInstances(scene, upload, camera, LightSpace::Camera));

    PlaneBuffers buffers{gpu.textures.acquire(size, GL_RGBA32F), gpu.textures.acquire(size, GL_R32UI)};
    const gl::Texture depth = gpu.textures.acquire(size, GL_DEPTH_COMPONENT32F);
    const gl::Framebuffer target{gpu.api, {&buffers.planes, &buffers.triangles}, &depth};
    gl::prepareDrawing(gpu, gl::Program::DrawPlanes, target);
    showTile(gpu, gl::Program::DrawPlanes, tile);
    drawScene(gpu, gl::Program::DrawPlanes, upload, target, projection, camera, hiddenBacks(scene, camera));
    drawLayers(gpu, upload, buffers.planes, depth, projection, tile, camera, unit, hiddenBacks(scene, camera));
    return buffers;
}

PlanesAndSurface drawPlanesAndSurface(gl::Gpu& gpu, const gl::UploadedScene& upload, const Scene& scene,
                                      const Camera& camera, LightSpace lightSpace, const Tile& tile) {
    const Size size = tile.drawn.size;
    const double unit = unitLength(scene);
    const glm::dmat4 projection = reversedProjection(camera, tile.whole, unit);
    upload.place(placeInstances(scene, upload, camera, lightSpace));

    PlanesAndSurface buffers{
        {gpu.textures.acquire(size, GL_RGBA32F), gpu.textures.acquire(size, GL_R32UI)},
        {gpu.textures.acquire(size, GL_RGBA32F), gpu.textures.acquire(size, GL_DEPTH_COMPONENT32F)}};
    auto& [planes, surface] = buffers;
    const gl::Framebuffer target{gpu.api, {&planes.planes, &planes.triangles, &surface.surface}, &surface.depth};
    gl::prepareDrawing(gpu, gl::Program::DrawPlanesAndSurface, target);
    showTile(gpu, gl::Program::DrawPlanesAndSurface, tile);
    const std::array background{0.0F, 0.0F, 0.0F, static_cast<float>(camera.far)};
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 2, background.data());
    gpu.api.ProgramUniform1f(gpu.programs.id(gl::Program::DrawPlanesAndSurface), 3, static_cast<float>(unit));
    drawScene(gpu, gl::Program::DrawPlanesAndSurface, upload, target, projection, camera, hiddenBacks(scene, camera));
    drawLayers(gpu, upload, planes.planes, surface.depth, projection, tile, camera, unit, hiddenBacks(scene, camera));
    return buffers;
}

}  // namespace inkedge
