#include "passes/draw_fattened.h"

#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "gl/draw.h"
#include "gl/read_back.h"
#include "passes/instance_transforms.h"
#include "passes/lift.h"
#include "passes/show_tile.h"

namespace inkedge::passes {
namespace {

// Footprints that fins lie nearer than their faces, and enlargements further off than their edges: reference.h has the
// same number.
constexpr double lift = 0.25;

// As shaders/draw_fattened.geom takes it.
glm::vec4 eyeOf(const Frame& frame) {
    const glm::dmat3 toWorld = glm::transpose(glm::dmat3{frame.camera.view});
    if (frame.camera.orthographic()) return {toWorld[2], 0.0};
    const glm::dvec3 eye = -(toWorld * glm::dvec3{frame.camera.view[3]});
    return {(eye - frame.scene.bounds().centre) / frame.unit, 1.0};
}

void setUniforms(const Frame& frame, GLuint id, double width) {
    const gl::Api& api = frame.gpu.api;
    const glm::dmat4 projection = reversedProjection(frame);
    const auto [x, y, size] = raster::viewOf(frame.tile);
    api.ProgramUniformMatrix4fv(id, 0, 1, GL_FALSE, glm::value_ptr(glm::mat4{projection}));
    api.ProgramUniform4fv(id, 1, 1, glm::value_ptr(eyeOf(frame)));
    api.ProgramUniform4f(id, 2, static_cast<float>(x - frame.tile.drawn.x), static_cast<float>(y - frame.tile.drawn.y),
                         static_cast<float>(size.width), static_cast<float>(size.height));
    api.ProgramUniform1f(id, 3, static_cast<float>(width));
    api.ProgramUniform1f(id, 7, static_cast<float>(liftInClipSpace(frame, projection, lift)));
}

}  // namespace

Image<std::uint8_t> drawFattened(const Frame& frame, gl::FunctionInputs& inputs, double width) {
    constexpr auto program = gl::Program::DrawFattened;
    gl::Gpu& gpu = frame.gpu;
    const gl::Texture ink = gpu.textures.acquire(frame.tile.drawn.size, GL_R8);
    const gl::Texture depth = gpu.textures.acquire(frame.tile.drawn.size, GL_DEPTH_COMPONENT32F);
    const gl::Framebuffer target{gpu.api, {&ink}, &depth};
    frame.upload.setTransforms(instanceTransforms(frame, LightSpace::Camera));
    gl::prepareDrawing(gpu, program, target);
    showTile(gpu, program, frame.tile);
    constexpr float zeros[4]{};  // paper, and farthest
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 0, zeros);
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, zeros);
    setUniforms(frame, gpu.programs.id(program), width);
    inputs.bindFaceEdges(frame.scene);
    frame.upload.draw(gl::UploadedScene::Triangles::All, gl::UploadedScene::HiddenBacks::Draw);
    return gl::readBytes(gpu.api, ink, 1);
}

}  // namespace inkedge::passes
