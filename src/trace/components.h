#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <inkedge/scene.h>

#include "base/union_find.h"
#include "scene/scene_face.h"

namespace inkedge::trace {

/// Which faces are connected across edges, whether these are creases or not.
class Components {
public:
    /// @param scene  must outlive it
    explicit Components(const Scene& scene) : scene_{scene}, patches_(scene.meshes().size()) {}

    /// O(1), but for the first question about a mesh: O(n).
    [[nodiscard]] bool connect(scene::SceneFace, scene::SceneFace);

private:
    const Scene& scene_;
    std::vector<std::optional<base::UnionFind>> patches_;  // one per mesh
};

}  // namespace inkedge::trace
