#pragma once

#include <glm/mat4x4.hpp>

#include <inkedge/camera.h>
#include <inkedge/scene.h>

#include "gl/gpu.h"
#include "gl/upload.h"
#include "raster/tiles.h"

namespace inkedge::passes {

/// What the passes of one view share: what they draw with, what they draw, and which part of the picture. All that it
/// refers to must outlive it.
struct Frame {
    gl::Gpu& gpu;
    const gl::UploadedScene& upload;  ///< of the scene
    const Scene& scene;
    const Camera& camera;
    /// Scene units in a unit length: the scene's radius. Lengths are handed to the graphics processor in unit lengths,
    /// so that no product of floats overflows or vanishes, however small or large the scene is.
    double unit;
    /// Backs that closed meshes hide are skipped if the camera stands outside the scene and its near plane cuts none of
    /// it.
    gl::UploadedScene::HiddenBacks hiddenBacks;
    raster::Tile tile;  ///< counted in samples, or in pixels: see inPixels()
};

[[nodiscard]] Frame frameOf(gl::Gpu&, const gl::UploadedScene&, const Scene&, const Camera&, const raster::Tile&);

/// The same frame of another tile.
[[nodiscard]] Frame withTile(Frame, const raster::Tile&);

/// The same frame, its tile counted in pixels of so many samples along each axis. Buffers of planes are drawn in
/// samples, buffers of surfaces in pixels.
[[nodiscard]] Frame inPixels(const Frame&, int samplesPerPixel);

/// View space in unit lengths -> clip space with depth from 1 at near to 0 at far: floats are then fine where
/// perspective is coarse.
[[nodiscard]] glm::dmat4 reversedProjection(const Frame&);

}  // namespace inkedge::passes
