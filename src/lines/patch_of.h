#pragma once

#include <cstdint>

#include <inkedge/scene.h>

#include "scene/scene_face.h"
#include "scene/patch_numbers.h"
#include "scene/topology.h"

namespace inkedge::lines {

/// The number of a face's patch (PatchNumbers::number).
[[nodiscard]] inline std::uint32_t patchOf(const Scene& scene, SceneFace face) {
    const PatchNumbers& patches = scene.patchNumbers();
    const MeshTopology& topology = scene.topology(scene.instances()[face.instance].mesh);
    return patches.number[patches.base[face.instance] + topology.patches[face.triangle]];
}

}  // namespace inkedge::lines
