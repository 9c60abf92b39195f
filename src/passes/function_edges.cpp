#include "passes/function_edges.h"

#include "gl/draw.h"
#include "gl/read_back.h"
#include "passes/draw_function.h"
#include "passes/ink_over.h"

namespace inkedge {
namespace {

// 255 where the magnitude is at least T: equation 7.
void markEdges(const Image<float>& magnitude, float threshold, Image<std::uint8_t>& edges) {
    for (std::size_t i = 0; i < magnitude.pixels.size(); ++i) {
        if (magnitude.pixels[i] >= threshold) edges.pixels[i] = 255;
    }
}

}  // namespace

gl::Texture measureFunction(gl::Gpu& gpu, const gl::Texture& values, const FunctionSettings& function) {
    const gl::Program program =
        function.kernel == Kernel::Sobel ? gl::Program::MeasureFunctionSobel : gl::Program::MeasureFunctionFarid;
    gpu.api.ProgramUniform1f(gpu.programs.id(program), 0, static_cast<float>(wrapPeriod(function)));
    gl::Texture magnitude = gpu.textures.acquire(values.size(), GL_R32F);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&magnitude}}, {&values});
    return magnitude;
}

Image<std::uint8_t> functionEdges(gl::Gpu& gpu, const gl::UploadedScene& upload, gl::FunctionInputs& inputs,
                                  const Scene& scene, const Camera& camera,
                                  const std::vector<FunctionSettings>& functions, const Tile& tile, int samples) {
    Image<std::uint8_t> edges{tile.drawn.size, 1};
    for (const FunctionSettings& function : functions) {
        const gl::Texture values = drawFunction(gpu, upload, inputs, scene, camera, function, tile);
        markEdges(gl::readFloats(gpu.api, measureFunction(gpu, values, function), 1), threshold(function), edges);
    }
    return meanOf(std::move(edges), samples);
}

}  // namespace inkedge
