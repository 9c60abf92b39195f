#include "passes/function_edges.h"

#include "gl/draw.h"
#include "gl/read_back.h"
#include "passes/draw_function.h"
#include "passes/ink_over.h"

namespace inkedge::passes {
namespace {

// The programs for each kernel, without and with differences modulo a period.
struct Programs {
    gl::Program sobel;
    gl::Program farid;
    gl::Program wrappedSobel;
    gl::Program wrappedFarid;
};
constexpr Programs detecting{gl::Program::DetectFunctionSobel, gl::Program::DetectFunctionFarid,
                             gl::Program::DetectWrappedFunctionSobel, gl::Program::DetectWrappedFunctionFarid};
constexpr Programs measuring{gl::Program::MeasureFunctionSobel, gl::Program::MeasureFunctionFarid,
                             gl::Program::MeasureWrappedFunctionSobel, gl::Program::MeasureWrappedFunctionFarid};

// Prepares drawing, except for the threshold.
gl::Program prepared(gl::Gpu& gpu, const Programs& programs, const FunctionSettings& function) {
    const bool sobel = function.kernel == Kernel::Sobel;
    const double period = wrapPeriod(function);
    if (period == 0.0) return sobel ? programs.sobel : programs.farid;
    const gl::Program program = sobel ? programs.wrappedSobel : programs.wrappedFarid;
    gpu.api.ProgramUniform1f(gpu.programs.id(program), 1, static_cast<float>(period));
    return program;
}

void add(const Image<std::uint32_t>& more, Image<std::uint32_t>& blocks) {
    if (blocks.empty()) blocks = Image<std::uint32_t>{more.size(), 1};
    for (std::size_t i = 0; i < more.pixels().size(); ++i) blocks.mutablePixels()[i] |= more.pixels()[i];
}

}  // namespace

gl::Texture detectFunction(gl::Gpu& gpu, const gl::Texture& values, const FunctionSettings& function) {
    const gl::Program program = prepared(gpu, detecting, function);
    gpu.api.ProgramUniform1f(gpu.programs.id(program), 0, threshold(function));
    gl::Texture marks = gpu.textures.acquire(blocksOf(values.size()), GL_R32UI);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&marks}}, {&values});
    return marks;
}

gl::Texture measureFunction(gl::Gpu& gpu, const gl::Texture& values, const FunctionSettings& function) {
    gl::Texture magnitude = gpu.textures.acquire(values.size(), GL_R32F);
    gl::drawFullscreen(gpu, prepared(gpu, measuring, function), gl::Framebuffer{gpu.api, {&magnitude}}, {&values});
    return magnitude;
}

Image<std::uint8_t> functionEdges(const Frame& frame, gl::FunctionInputs& inputs,
                                  const std::vector<FunctionSettings>& functions, int samples) {
    gl::Gpu& gpu = frame.gpu;
    EdgeMarks marks{frame.tile.drawn.size, {}};
    for (const FunctionSettings& function : functions) {
        const gl::Texture values = drawFunction(frame, inputs, function);
        add(gl::readIntegers(gpu.api, detectFunction(gpu, values, function)), marks.blocks);
    }
    return meanOf(mask(marks, EdgeMarks::functionEdge), samples);
}

}  // namespace inkedge::passes
