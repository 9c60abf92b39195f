#include "passes/draw_surface.h"

#include <array>

#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "gl/draw.h"
#include "passes/combine_lights.h"

namespace inkedge {
namespace {

constexpr GLint projectionLocation = 0;
constexpr GLint unitLengthLocation = 1;

// Lengths are handed to the graphics processor in units of the scene's radius, so that no product of floats overflows or
// vanishes, however small or large the scene is.
double unitLength(const Scene& scene) { return scene.bounds().radius > 0.0 ? scene.bounds().radius : 1.0; }

// Clip space with depth from 1 at near to 0 at far: floats are then fine where perspective is coarse.
glm::dmat4 reversedProjection(const Camera& camera, Size size, double unit) {
    Camera scaled = camera;
    scaled.near /= unit;
    scaled.far /= unit;
    scaled.orthographicHeight /= unit;
    glm::dmat4 reverse{1.0};
    reverse[2][2] = -0.5;
    reverse[3][2] = 0.5;
    return reverse * scaled.projection(size);
}

void storeRows(const glm::dmat4& matrix, glm::vec4 (&rows)[3]) {
    const glm::dmat4 transposed = glm::transpose(matrix);
    for (int row = 0; row < 3; ++row) rows[row] = glm::vec4{transposed[row]};
}

// Inverse transpose up to a positive factor, which also exists where a scale is zero: the cofactors, whose sign a mirror
// turns round.
glm::dmat3 normalMatrix(const glm::dmat3& m) {
    const glm::dmat3 cofactors{glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1])};
    double largest = 0.0;
    for (int column = 0; column < 3; ++column) largest = std::max(largest, glm::length(cofactors[column]));
    const double sign = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    return largest > 0.0 ? cofactors * (sign / largest) : cofactors;
}

std::vector<gl::UploadedScene::PlacedInstance> placeInstances(const Scene& scene, const gl::UploadedScene& upload,
                                                              const Camera& camera, LightSpace lightSpace) {
    glm::dmat4 scale{1.0 / unitLength(scene)};
    scale[3][3] = 1.0;
    std::vector<gl::UploadedScene::PlacedInstance> placements;
    placements.reserve(upload.instanceOrder().size());
    for (const std::uint32_t i : upload.instanceOrder()) {
        const Instance& instance = scene.instances()[i];
        glm::dmat4 fromOrigin{1.0};
        fromOrigin[3] = glm::dvec4{scene.meshes()[instance.mesh].origin, 1.0};
        const glm::dmat4 modelView = scale * camera.view * instance.transform * fromOrigin;
        auto& placed = placements.emplace_back();
        storeRows(modelView, placed.modelView);
        const glm::dmat4& lit = lightSpace == LightSpace::World ? instance.transform : modelView;
        storeRows(glm::dmat4{normalMatrix(glm::dmat3{lit})}, placed.normalMatrix);
    }
    return placements;
}

void setUniforms(gl::Gpu& gpu, gl::Program program, const glm::mat4& projection, double unit) {
    const GLuint id = gpu.programs.id(program);
    gpu.api.ProgramUniformMatrix4fv(id, projectionLocation, 1, GL_FALSE, glm::value_ptr(projection));
    gpu.api.ProgramUniform1f(id, unitLengthLocation, static_cast<float>(unit));
}

}  // namespace

SurfaceBuffers drawSurface(gl::Gpu& gpu, const gl::UploadedScene& upload, const Scene& scene, const Camera& camera,
                           const DetectorSettings& settings, Size size) {
    const double unit = unitLength(scene);
    const glm::mat4 projection{reversedProjection(camera, size, unit)};
    const auto placements = placeInstances(scene, upload, camera, settings.lightSpace);
    gl::Texture depth = gpu.textures.acquire(size, GL_DEPTH_COMPONENT32F);

    const auto draw = [&](gl::Program program, GLenum format, const std::array<float, 4>& background) {
        gl::Texture color = gpu.textures.acquire(size, format);
        const gl::Framebuffer target{gpu.api, {&color}, &depth};
        gl::prepareDrawing(gpu, program, target);
        constexpr float farthest = 0.0F;
        gpu.api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 0, background.data());
        gpu.api.ClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, &farthest);
        setUniforms(gpu, program, projection, unit);
        upload.draw(placements);
        return color;
    };
    if (settings.normalLights == NormalLights::Single) {
        gl::Texture surface =
            draw(gl::Program::DrawSurface, GL_RGBA32F, {0.0F, 0.0F, 0.0F, static_cast<float>(camera.far)});
        return {std::move(surface), std::move(depth)};
    }
    const gl::Texture positive = draw(gl::Program::DrawPositiveLights, GL_RGBA8, {});
    const gl::Texture negative = draw(gl::Program::DrawNegativeLights, GL_RGBA8, {});
    gl::Texture surface = combineLights(gpu, positive, negative, depth, camera);
    return {std::move(surface), std::move(depth)};
}

}  // namespace inkedge
