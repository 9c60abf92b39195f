#include "passes/draw_function.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <inkedge/error.h>
#include <inkedge/settings.h>

#include "gl/draw.h"
#include "passes/depth_uniforms.h"
#include "passes/instance_transforms.h"
#include "passes/missing_attributes.h"
#include "passes/show_tile.h"
#include "scene/extent.h"

namespace inkedge::passes {
namespace {

// The background's last channel if the function has no value there; measure_function.frag knows it.
constexpr float noValue = 1e30F;

void expectCoordinates(const Scene& scene, const FunctionDescription& row) {
    if (!row.needs.coordinates || row.name == customFunction) return;
    if (std::ranges::any_of(scene.meshes(), [](const Mesh& mesh) { return !mesh.textureCoordinates.empty(); })) return;
    throw Error{Error::Kind::Input,
                fmt::format("function {}: expected a model with texture coordinates, found none", row.name)};
}

// shaders/shared/surface.glsl.
void setUniforms(const Frame& frame, GLuint program, const FunctionSettings& function) {
    const auto& [gpu, upload, scene, camera, unit, hiddenBacks, tile] = frame;
    const gl::Api& api = gpu.api;
    const glm::dvec3 centre = scene.bounds().centre;
    const glm::dmat3 toWorld = glm::transpose(glm::dmat3{camera.view});
    const glm::vec3 eye{-(toWorld * glm::dvec3{camera.view[3]}) - centre};
    const glm::vec3 lowest{scene.box().min - centre};
    const glm::vec3 extent{scene.box().max - scene.box().min};
    api.ProgramUniformMatrix3fv(program, 8, 1, GL_FALSE, glm::value_ptr(glm::mat3{toWorld}));
    api.ProgramUniform3fv(program, 9, 1, glm::value_ptr(eye));
    api.ProgramUniform3fv(program, 10, 1, glm::value_ptr(lowest));
    api.ProgramUniform3fv(program, 11, 1, glm::value_ptr(extent));
    api.ProgramUniform1f(program, 12, static_cast<float>(unit));
    setDepths(gpu, program, 13, camera);
    api.ProgramUniform1i(program, 16, function.file.empty() ? 0 : 1);
    const glm::dvec3 up = scene.up();
    const double floor = -scene::support(scene, -up);
    const double height = scene::support(scene, up) - floor;
    api.ProgramUniform3fv(program, 25, 1, glm::value_ptr(glm::vec3{up}));
    api.ProgramUniform2f(program, 26, static_cast<float>(floor - glm::dot(centre, up)), static_cast<float>(height));
    const std::vector<float> options(function.options.begin(), function.options.end());
    if (!options.empty()) api.ProgramUniform1fv(program, 17, static_cast<GLsizei>(options.size()), options.data());
}

}  // namespace

gl::Texture drawFunction(const Frame& frame, gl::FunctionInputs& inputs, const FunctionSettings& function) {
    const auto& [gpu, upload, scene, camera, unit, hiddenBacks, tile] = frame;
    const FunctionDescription& row = functionDescription(function.name);
    expectCoordinates(scene, row);
    const bool custom = row.name == customFunction;
    const GLuint program = custom ? gpu.programs.customFunction(function.file) : gpu.programs.function(function.name);
    gl::Texture values = gpu.textures.acquire(tile.drawn.size, GL_RGBA32F);
    const gl::Texture depth = gpu.textures.acquire(tile.drawn.size, GL_DEPTH_COMPONENT32F);
    const gl::Framebuffer target{gpu.api, {&values}, &depth};
    upload.setTransforms(instanceTransforms(frame, LightSpace::Camera));
    gl::prepareDrawing(gpu, program, target);
    showTile(gpu, program, tile);
    const float behind = row.background.value_or(0.0F);
    const std::array background{behind, 0.0F, 0.0F, row.background ? 0.0F : noValue};
    constexpr float farthest = 0.0F;
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 0, background.data());
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &farthest);
    const glm::mat4 projection{reversedProjection(frame)};
    gpu.api.ProgramUniformMatrix4fv(program, 0, 1, GL_FALSE, glm::value_ptr(projection));
    setUniforms(frame, program, function);
    setMissingAttributes(gpu.api);
    if (!custom && !function.file.empty()) inputs.bindPicture(function.file);
    if (row.needs.paint) inputs.bindPaint(scene);
    upload.draw(gl::UploadedScene::Triangles::All, hiddenBacks);
    return values;
}

}  // namespace inkedge::passes
