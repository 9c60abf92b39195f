#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "lines/find/face_tree.h"

namespace inkedge::lines {

/// Four cones side by side.
struct FourCones {
    Four axis[3]{};
    /// How far a unit normal in the cone, or its opposite, may be from the axis, which has unit length. At noNormals no
    /// face has a normal; at wide the cone is of no use.
    Four radius = four(noNormals);

    static constexpr float noNormals = -4.0F;
    static constexpr float wide = 4.0F;
};

/// Cones around the normals of the faces below each node of a tree, so that a search for faces that cross can skip
/// nodes that are nearly flat. Levels are those of BoxLevels.
class FaceCones {
public:
    /// @param normals  one per triangle of the mesh: faces whose normal is 0 have none
    /// @param widest   wider cones are not kept; of a radius
    FaceCones(const FaceTree&, std::span<const glm::dvec3> normals, float widest);

    /// The cones of nodes 4 i to 4 i + 3 of a level.
    [[nodiscard]] const FourCones& cones(std::uint32_t level, std::uint32_t i) const noexcept {
        return levels_[level][i];
    }

private:
    std::vector<std::vector<FourCones>> levels_;
};

}  // namespace inkedge::lines
