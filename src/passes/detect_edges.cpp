#include "passes/detect_edges.h"

#include "gl/draw.h"
#include "gl/read_back.h"
#include "passes/depth_uniforms.h"

namespace inkedge::passes {
namespace {

// Sets what both programs read: shaders/shared/edges.glsl.
void setInputs(gl::Gpu& gpu, gl::Program program, const Camera& camera, const DetectorSettings& settings) {
    setDepths(gpu, program, 0, camera);
    gpu.api.ProgramUniform1i(gpu.programs.id(program), 3, settings.depthMap == DepthMap::Window ? 1 : 0);
}

gl::Texture markEdges(gl::Gpu& gpu, const gl::Texture& surface, const Camera& camera,
                      const DetectorSettings& settings) {
    const gl::Program program =
        settings.kernel == Kernel::Sobel ? gl::Program::DetectEdgesSobel : gl::Program::DetectEdgesFarid;
    setInputs(gpu, program, camera, settings);
    gpu.api.ProgramUniform1f(gpu.programs.id(program), 4, thresholds(settings).depth);
    gpu.api.ProgramUniform1f(gpu.programs.id(program), 5, thresholds(settings).normal);
    gl::Texture marks = gpu.textures.acquire(blocksOf(surface.size()), GL_R32UI);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&marks}}, {&surface});
    return marks;
}

gl::Texture measureEdges(gl::Gpu& gpu, const gl::Texture& surface, const Camera& camera,
                         const DetectorSettings& settings) {
    const gl::Program program =
        settings.kernel == Kernel::Sobel ? gl::Program::MeasureEdgesSobel : gl::Program::MeasureEdgesFarid;
    setInputs(gpu, program, camera, settings);
    gl::Texture magnitudes = gpu.textures.acquire(surface.size(), GL_RG32F);
    gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&magnitudes}}, {&surface});
    return magnitudes;
}

}  // namespace

EdgeBuffers detectEdges(gl::Gpu& gpu, const gl::Texture& surface, const Camera& camera,
                        const DetectorSettings& settings, Magnitudes magnitudes) {
    EdgeBuffers edges{surface.size(), markEdges(gpu, surface, camera, settings), {}};
    if (magnitudes == Magnitudes::Keep) edges.magnitudes = measureEdges(gpu, surface, camera, settings);
    return edges;
}

EdgeMarks readMarks(const gl::Api& api, const EdgeBuffers& edges) {
    return {edges.size, gl::readIntegers(api, edges.marks)};
}

}  // namespace inkedge::passes
