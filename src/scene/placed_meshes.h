#pragma once

#include <span>

#include <inkedge/bounds.h>
#include <inkedge/scene.h>

#include "mesh/topology.h"

namespace inkedge {

/// Prepared meshes and where they stand: what seams, layers and patches' numbers are worked out from.
struct PlacedMeshes {
    std::span<const Mesh> meshes;
    std::span<const MeshTopology> topologies;  ///< one a mesh
    std::span<const Instance> instances;
    Sphere bounds;  ///< around everything placed, in world space

    [[nodiscard]] const Mesh& meshOf(std::size_t instance) const { return meshes[instances[instance].mesh]; }
    [[nodiscard]] const MeshTopology& topologyOf(std::size_t instance) const {
        return topologies[instances[instance].mesh];
    }
};

}  // namespace inkedge
