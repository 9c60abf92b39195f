#include "passes/combine_lights.h"

#include "gl/draw.h"
#include "passes/depth_uniforms.h"

namespace inkedge::passes {

gl::Texture combineLights(gl::Gpu& gpu, const gl::Texture& positive, const gl::Texture& negative,
                          const gl::Texture& depth, const Camera& camera) {
    gl::Texture surface = gpu.textures.acquire(depth.size(), GL_RGBA32F);
    setDepths(gpu, gl::Program::CombineLights, 0, camera);
    gl::drawFullscreen(gpu, gl::Program::CombineLights, gl::Framebuffer{gpu.api, {&surface}},
                       {&positive, &negative, &depth});
    return surface;
}

}  // namespace inkedge::passes
