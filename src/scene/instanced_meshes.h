#pragma once

#include <span>

#include <inkedge/bounds.h>
#include <inkedge/scene.h>

#include "mesh/topology.h"

namespace inkedge::scene {

/// Instances of prepared meshes: what seams, layers and patch numbers are computed from.
struct InstancedMeshes {
    std::span<const Mesh> meshes;
    std::span<const mesh::MeshTopology> topologies;  ///< one per mesh
    std::span<const Instance> instances;
    Sphere bounds;  ///< around all instances, in world space

    [[nodiscard]] const Mesh& meshOf(std::size_t instance) const { return meshes[instances[instance].mesh]; }
    [[nodiscard]] const mesh::MeshTopology& topologyOf(std::size_t instance) const {
        return topologies[instances[instance].mesh];
    }
};

}  // namespace inkedge::scene
