#pragma once

#include <cstdint>
#include <vector>

#include "scene/instanced_meshes.h"

namespace inkedge::scene {

/// The patches of a whole scene: those of each instance, numbered from 1 in the order of instances.
struct PatchNumbers {
    std::vector<std::uint32_t> base;  ///< one per instance: the index of its first patch in the arrays below
    std::vector<std::uint32_t>
        number;                 ///< one per patch: 1 or more; those of one surface, and across a seam, have the same
    std::vector<bool> layered;  ///< one per patch: whether faces of it overlap others in one plane
    std::uint32_t count = 0;    ///< the largest number
};

/// Numbers the patches, joins them across seams and finds coplanar layers.
///
/// A seam is where the borders of two surfaces run along each other (T-junctions, surfaces cut along a line, meshes
/// split by material or node) and the surfaces do not meet in a crease: they are drawn as one surface. A layer is
/// a face that overlaps a face of another patch in one plane. The depth test cannot choose between the two faces, so
/// the lines of both are drawn.
[[nodiscard]] PatchNumbers numberPatches(const InstancedMeshes&, const LoadSettings&);

}  // namespace inkedge::scene
