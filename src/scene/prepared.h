#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <inkedge/bounds.h>
#include <inkedge/scene.h>

#include "mesh/topology.h"
#include "scene/instanced_meshes.h"
#include "scene/patch_numbers.h"
#include "scene/scene_face.h"
#include "scene/shared_once.h"

namespace inkedge {

/// What a Scene holds: its data, checked and made ready to be drawn, and what is computed from the data once. For the
/// library's own rooms.
struct PreparedScene {
    Scene::Data data;
    std::vector<Box> meshBoxes;                  ///< one per mesh: of its positions, less its origin
    std::vector<mesh::MeshTopology> topologies;  ///< one per mesh, without its faceNormals
    std::vector<std::uint32_t> oneSided;         ///< one per mesh: oneSidedTriangles()
    std::vector<bool> hidesItsBacks;             ///< one per mesh: hidesItsBacks()
    Box box;                                     ///< of everything drawn, in world space
    Sphere bounds;                               ///< around everything drawn, in world space
    LoadSettings loadedWith;                     ///< what the constructor was given
    std::vector<glm::dmat4> transforms;          ///< one per instance, as the data had them
    std::uint64_t triangleCount = 0;             ///< of all instances
    scene::PatchNumbers patchNumbers;
    /// Degrees: creases within a patch bend by this at least; those between patches may bend by less.
    double minCreaseBend = 0.0;
    double milliseconds = 0.0;  ///< that preparation took
    /// What the room of lines makes of it, for all who look for its lines at the same time.
    std::unique_ptr<scene::SharedOnce> lines = std::make_unique<scene::SharedOnce>();
};

[[nodiscard]] const std::shared_ptr<const PreparedScene>& preparedOf(const Scene&) noexcept;

namespace scene {

/// How the triangles of mesh i are connected.
[[nodiscard]] inline const mesh::MeshTopology& topologyOf(const Scene& scene, std::size_t i) {
    return preparedOf(scene)->topologies[i];
}

/// How many triangles of mesh i, the first ones, are seen from their front only: LoadSettings::backFaces.
[[nodiscard]] inline std::uint32_t oneSidedTriangles(const Scene& scene, std::size_t i) {
    return preparedOf(scene)->oneSided[i];
}

/// Whether mesh i's faces are all single-sided and close it, wound outward: from outside no back of them is seen.
[[nodiscard]] inline bool hidesItsBacks(const Scene& scene, std::size_t i) {
    return preparedOf(scene)->hidesItsBacks[i];
}

/// Degrees: faces of one patch that bend by less than this do not meet in a crease.
[[nodiscard]] inline double minCreaseBend(const Scene& scene) { return preparedOf(scene)->minCreaseBend; }

/// The patches of all instances.
[[nodiscard]] inline const PatchNumbers& patchNumbersOf(const Scene& scene) { return preparedOf(scene)->patchNumbers; }

[[nodiscard]] inline InstancedMeshes instancedMeshesOf(const Scene& scene) {
    const PreparedScene& prepared = *preparedOf(scene);
    return {prepared.data.meshes, prepared.topologies, prepared.data.instances, prepared.bounds};
}

/// An identity that all copies of one scene share, and no other living scene has.
[[nodiscard]] inline std::weak_ptr<const void> identityOf(const Scene& scene) { return preparedOf(scene); }

/// The number of a face's patch.
[[nodiscard]] inline std::uint32_t patchOf(const Scene& scene, SceneFace face) {
    const PatchNumbers& patches = patchNumbersOf(scene);
    const mesh::MeshTopology& topology = topologyOf(scene, scene.instances()[face.instance].mesh);
    return patches.number[patches.base[face.instance] + topology.patches[face.triangle]];
}

}  // namespace scene

}  // namespace inkedge
