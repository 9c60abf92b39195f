#pragma once

#include <span>
#include <string>
#include <vector>

#include <inkedge/export.h>
#include <inkedge/mesh_arrays.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

namespace inkedge {

/// A mesh in memory, and where it stands.
struct InstancedArrays {
    MeshArrays mesh;
    /// Instances x 16, real numbers, finite: the rows of a 4 x 4 matrix for column vectors each, mesh space -> world,
    /// affine. No rows: one instance, in the world as in mesh space.
    ArrayView transforms = {};
    std::vector<std::string> names = {};  ///< one an instance; none: all are called as the mesh is
};

/// Copies meshes and instances into a scene. Of the settings those of files (scene, animation, time) do nothing.
/// @throws Error  (Kind::Usage) as makeMesh(), if a matrix is not affine, or there are other names than instances; of
///                several meshes the message says which; otherwise as Scene's constructor
[[nodiscard]] INKEDGE_API Scene makeScene(std::span<const InstancedArrays>, const LoadSettings& = {});

}  // namespace inkedge
