#pragma once

#include <cstdint>
#include <vector>

#include "scene/placed_meshes.h"

namespace inkedge {

/// The patches of a whole scene: those of each instance, numbered from 1 in the order of instances.
struct PatchNumbers {
    std::vector<std::uint32_t> base;    ///< one an instance: where its patches begin in the arrays below
    std::vector<std::uint32_t> number;  ///< one an instance's patch: 1 or more; patches that a seam joins share theirs
    std::vector<bool> layered;          ///< one an instance's patch: faces of it overlap others in one plane
    std::uint32_t count = 0;            ///< the largest number
};

/// Numbers the patches, joins them across seams and finds coplanar layers.
///
/// A seam is where the borders of two surfaces run along each other (T-junctions, parts cut along a line, meshes split
/// by material or node) and the surfaces go on across it at less than the crease angle: what is drawn as one surface.
/// A layer is a face that shares a part of its plane with a face of another patch: there the depth test cannot choose,
/// so the lines of both must show.
[[nodiscard]] PatchNumbers numberPatches(const PlacedMeshes&, double creaseAngle);

}  // namespace inkedge
