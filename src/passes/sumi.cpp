#include "passes/sumi.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "gl/draw.h"
#include "passes/depth_uniforms.h"
#include "passes/read_ink.h"

namespace inkedge::passes {
namespace {

// Standard deviations of blurs, pixels: of the channels, and of the structure tensor.
double brushSigma(const StyleSettings& settings) { return std::max(0.25 * settings.sumiWidth, 0.7); }
double tensorSigma(const StyleSettings& settings) { return std::max(0.5 * settings.sumiWidth, 2.0); }

constexpr double reachInSigmas = 2.5;
int radiusOf(double sigma) { return static_cast<int>(std::ceil(reachInSigmas * sigma)); }

int stepsOf(const StyleSettings& settings) { return static_cast<int>(std::lround(settings.sumiLength)); }

// The weights of a Gaussian: of the middle, and of the points up to so many steps away on either side.
std::vector<float> gaussian(double sigma, int radius) {
    std::vector<double> weights(static_cast<std::size_t>(radius) + 1, 1.0);
    double sum = 1.0;
    for (std::size_t i = 1; i < weights.size(); ++i) {
        const double away = static_cast<double>(i) / sigma;
        weights[i] = std::exp(-0.5 * away * away);
        sum += 2.0 * weights[i];
    }
    std::vector<float> normalised;
    for (const double weight : weights) normalised.push_back(static_cast<float>(weight / sum));
    return normalised;
}

void setWeights(gl::Gpu& gpu, GLuint id, GLint location, const std::vector<float>& weights) {
    gpu.api.ProgramUniform1fv(id, location, static_cast<GLsizei>(weights.size()), weights.data());
}

gl::Texture pass(gl::Gpu& gpu, gl::Program program, std::initializer_list<const gl::Texture*> inputs, GLenum format) {
    gl::Texture result = gpu.textures.acquire((*inputs.begin())->size(), format);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&result}}, inputs);
    return result;
}

gl::Texture blurred(gl::Gpu& gpu, const gl::Texture& image, double sigma) {
    constexpr auto program = gl::Program::Blur;
    const GLuint id = gpu.programs.id(program);
    gpu.api.ProgramUniform1i(id, 1, radiusOf(sigma));
    setWeights(gpu, id, 2, gaussian(sigma, radiusOf(sigma)));
    gpu.api.ProgramUniform2i(id, 0, 1, 0);
    const gl::Texture alongX = pass(gpu, program, {&image}, GL_RGBA32F);
    gpu.api.ProgramUniform2i(id, 0, 0, 1);
    return pass(gpu, program, {&alongX}, GL_RGBA32F);
}

gl::Texture feel(gl::Gpu& gpu, const gl::Texture& surface, const Camera& camera, const StyleSettings& settings) {
    constexpr auto program = gl::Program::SumiChannels;
    setDepths(gpu, program, 0, camera);
    gpu.api.ProgramUniform1f(gpu.programs.id(program), 3, static_cast<float>(settings.sumiStreaks));
    return blurred(gpu, pass(gpu, program, {&surface}, GL_RGBA32F), brushSigma(settings));
}

// The factor that makes a step of 1 a magnitude of 1. The steepest slope of a step that is blurred by sigma is its
// height over sigma times this root. A Sobel kernel blurs by a variance of 1/2 more, and gives a slope of 1 the
// magnitude 8.
float gainFor(double sigma) {
    return static_cast<float>(std::sqrt((sigma * sigma + 0.5) * 2.0 * std::numbers::pi) / 8.0);
}

gl::Texture tangents(gl::Gpu& gpu, const gl::Texture& channels, const StyleSettings& settings) {
    constexpr auto program = gl::Program::SumiGradients;
    gpu.api.ProgramUniform1f(gpu.programs.id(program), 0, gainFor(brushSigma(settings)));
    const gl::Texture tensor = pass(gpu, program, {&channels}, GL_RGBA32F);
    const gl::Texture smooth = blurred(gpu, tensor, tensorSigma(settings));
    return pass(gpu, gl::Program::SumiTangents, {&smooth, &tensor}, GL_RGBA32F);
}

gl::Texture smear(gl::Gpu& gpu, const gl::Texture& tangents, const StyleSettings& settings) {
    constexpr auto program = gl::Program::SumiBrush;
    const GLuint id = gpu.programs.id(program);
    const int steps = stepsOf(settings);
    gpu.api.ProgramUniform1i(id, 0, steps);
    setWeights(gpu, id, 1, gaussian(std::max(0.5 * steps, 1.0), steps));
    return pass(gpu, program, {&tangents}, GL_R32F);
}

}  // namespace

Image<std::uint8_t> sumi(const Frame& frame, const gl::Texture& surface, const StyleSettings& settings) {
    gl::Gpu& gpu = frame.gpu;
    const gl::Texture felt = feel(gpu, surface, frame.camera, settings);
    return readInk(gpu.api, smear(gpu, tangents(gpu, felt, settings), settings));
}

int sumiReach(const StyleSettings& settings) {
    return radiusOf(brushSigma(settings)) + 1 + radiusOf(tensorSigma(settings)) + stepsOf(settings);
}

}  // namespace inkedge::passes
