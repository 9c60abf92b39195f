#pragma once

#include <vector>

#include <glm/mat4x4.hpp>

#include <inkedge/camera.h>

#include "gl/upload.h"

namespace inkedge {

/// Lengths are handed to the graphics processor in units of the scene's radius, so that no product of floats overflows
/// or vanishes, however small or large the scene is.
[[nodiscard]] double unitLength(const Scene&);

/// View space in unit lengths -> clip space with depth from 1 at near to 0 at far: floats are then fine where
/// perspective is coarse.
[[nodiscard]] glm::dmat4 reversedProjection(const Camera&, Size, double unit);

/// Where each instance stands in view space, in the upload's order, and the matrix for its normals in the lights'
/// space.
[[nodiscard]] std::vector<gl::UploadedScene::PlacedInstance> placeInstances(const Scene&, const gl::UploadedScene&,
                                                                            const Camera&, LightSpace);

/// Backs that closed meshes hide are skipped if the camera stands outside the scene and its near plane cuts none of it.
[[nodiscard]] gl::UploadedScene::HiddenBacks hiddenBacks(const Scene&, const Camera&);

}  // namespace inkedge
