#include "passes/draw_shade.h"

#include <array>

#include <glm/gtc/type_ptr.hpp>

#include "gl/draw.h"
#include "gl/read_back.h"
#include "passes/instance_transforms.h"
#include "passes/missing_attributes.h"
#include "passes/show_tile.h"

namespace inkedge::passes {
namespace {

// The mean of each pixel's samples, which are there or not: their alpha is 255 or 0.
Image<std::uint8_t> meanColors(const Image<std::uint8_t>& colors, int samples) {
    if (samples == 1) return colors;
    Image<std::uint8_t> means{{colors.size().width / samples, colors.size().height / samples}, 4};
    const auto count = static_cast<unsigned>(samples * samples);
    for (int y = 0; y < means.size().height; ++y) {
        for (int x = 0; x < means.size().width; ++x) {
            std::array<unsigned, 3> sums{};
            unsigned covered = 0;
            for (int i = 0; i < samples * samples; ++i) {
                const std::uint8_t* const sample = &colors(samples * x + i % samples, samples * y + i / samples);
                if (sample[3] == 0) continue;
                ++covered;
                for (std::size_t c = 0; c < sums.size(); ++c) sums[c] += sample[c];
            }
            if (covered == 0) continue;
            for (std::size_t c = 0; c < sums.size(); ++c)
                means(x, y, static_cast<int>(c)) = static_cast<std::uint8_t>((sums[c] + covered / 2) / covered);
            means(x, y, 3) = static_cast<std::uint8_t>((255 * covered + count / 2) / count);
        }
    }
    return means;
}

}  // namespace

Image<std::uint8_t> drawShade(const Frame& frame, gl::FunctionInputs& inputs, Shade shade, glm::dvec3 towardsLight,
                              int samples) {
    constexpr auto program = gl::Program::DrawShade;
    gl::Gpu& gpu = frame.gpu;
    const gl::Texture colors = gpu.textures.acquire(frame.tile.drawn.size, GL_RGBA8);
    const gl::Texture depth = gpu.textures.acquire(frame.tile.drawn.size, GL_DEPTH_COMPONENT32F);
    const gl::Framebuffer target{gpu.api, {&colors}, &depth};
    frame.upload.setTransforms(instanceTransforms(frame, LightSpace::Camera));
    gl::prepareDrawing(gpu, program, target);
    showTile(gpu, program, frame.tile);
    constexpr float zeros[4]{};  // transparent, and farthest
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_COLOR, 0, zeros);
    gpu.api.ClearNamedFramebufferfv(target.id(), GL_DEPTH, 0, zeros);
    const GLuint id = gpu.programs.id(program);
    const glm::mat4 projection{reversedProjection(frame)};
    gpu.api.ProgramUniformMatrix4fv(id, 0, 1, GL_FALSE, glm::value_ptr(projection));
    gpu.api.ProgramUniform1i(id, 8, static_cast<GLint>(shade));
    gpu.api.ProgramUniform3fv(id, 9, 1, glm::value_ptr(glm::vec3{towardsLight}));
    gpu.api.ProgramUniform1i(id, 10, frame.camera.orthographic() ? 1 : 0);
    setMissingAttributes(gpu.api);
    inputs.bindPaint(frame.scene);
    frame.upload.draw(gl::UploadedScene::Triangles::All, frame.hiddenBacks);
    return meanColors(gl::readBytes(gpu.api, colors, 4), samples);
}

}  // namespace inkedge::passes
