#include "passes/frame.h"

#include "camera/stands_outside.h"

namespace inkedge::passes {

Frame frameOf(gl::Gpu& gpu, const gl::UploadedScene& upload, const Scene& scene, const Camera& camera,
              const raster::Tile& tile) {
    using enum gl::UploadedScene::HiddenBacks;
    const double radius = scene.bounds().radius;
    return {gpu, upload, scene, camera, radius > 0.0 ? radius : 1.0, camera::standsOutside(camera, scene) ? Skip : Draw,
            tile};
}

Frame withTile(Frame frame, const raster::Tile& tile) {
    frame.tile = tile;
    return frame;
}

Frame inPixels(const Frame& frame, int samplesPerPixel) {
    return withTile(frame, raster::inPixels(frame.tile, samplesPerPixel));
}

glm::dmat4 reversedProjection(const Frame& frame) {
    Camera scaled = frame.camera;
    scaled.near /= frame.unit;
    scaled.far /= frame.unit;
    scaled.orthographicHeight /= frame.unit;
    glm::dmat4 reverse{1.0};
    reverse[2][2] = -0.5;
    reverse[3][2] = 0.5;
    return reverse * scaled.projection(frame.tile.whole);
}

}  // namespace inkedge::passes
