#include "passes/detect_edges.h"

#include "gl/draw.h"
#include "passes/depth_uniforms.h"

namespace inkedge {
namespace {

gl::Program programFor(Kernel kernel, Magnitudes magnitudes) {
    const bool keep = magnitudes == Magnitudes::Keep;
    if (kernel == Kernel::Sobel) return keep ? gl::Program::MeasureEdgesSobel : gl::Program::DetectEdgesSobel;
    return keep ? gl::Program::MeasureEdgesFarid : gl::Program::DetectEdgesFarid;
}

}  // namespace

EdgeBuffers detectEdges(gl::Gpu& gpu, const gl::Texture& surface, const Camera& camera,
                        const DetectorSettings& settings, Magnitudes magnitudes) {
    const gl::Program program = programFor(settings.kernel, magnitudes);
    const GLuint id = gpu.programs.id(program);
    setDepths(gpu, program, 0, camera);
    gpu.api.ProgramUniform1i(id, 3, settings.depthMap == DepthMap::Window ? 1 : 0);
    gpu.api.ProgramUniform1f(id, 4, thresholds(settings).depth);
    gpu.api.ProgramUniform1f(id, 5, thresholds(settings).normal);

    EdgeBuffers edges{gpu.textures.acquire(surface.size(), GL_R8UI), {}};
    if (magnitudes == Magnitudes::Keep) {
        edges.magnitudes.emplace(gpu.textures.acquire(surface.size(), GL_RG32F));
        gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&edges.marks, &*edges.magnitudes}}, {&surface});
    } else {
        gl::drawFullscreen(gpu, program, gl::Framebuffer{gpu.api, {&edges.marks}}, {&surface});
    }
    return edges;
}

}  // namespace inkedge
