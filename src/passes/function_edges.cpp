#include "passes/function_edges.h"

#include "gl/draw.h"
#include "gl/read_back.h"
#include "passes/draw_function.h"

namespace inkedge {
namespace {

// 255 where the magnitude is at least T: equation 7.
void markEdges(const Image<float>& magnitude, float threshold, Image<std::uint8_t>& edges) {
    for (std::size_t i = 0; i < magnitude.pixels.size(); ++i) {
        if (magnitude.pixels[i] >= threshold) edges.pixels[i] = 255;
    }
}

// The mean of each pixel's samples.
Image<std::uint8_t> meanOf(Image<std::uint8_t> image, int samples) {
    if (samples == 1) return image;
    Image<std::uint8_t> means{{image.size.width / samples, image.size.height / samples}, 1};
    for (int y = 0; y < means.size.height; ++y) {
        for (int x = 0; x < means.size.width; ++x) {
            int sum = samples * samples / 2;
            for (int i = 0; i < samples * samples; ++i)
                sum += image.at(samples * x + i % samples, samples * y + i / samples);
            means.at(x, y) = static_cast<std::uint8_t>(sum / (samples * samples));
        }
    }
    return means;
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
