#pragma once

#include <array>

#include <glm/mat4x4.hpp>

#include <inkedge/scene.h>

namespace inkedge::scene {

/// The corners of one instance's triangles in world space, less an origin, in double precision.
class WorldTriangles {
public:
    WorldTriangles(const Scene& scene, const Instance& instance, glm::dvec3 origin)
        : WorldTriangles{scene.meshes()[instance.mesh], instance.transform, origin} {}
    WorldTriangles(const Mesh& mesh, const glm::dmat4& transform, glm::dvec3 origin)
        : mesh_{mesh}, transform_{transform} {
        transform_[3] += transform_ * glm::dvec4{mesh_.origin, 0.0} - glm::dvec4{origin, 0.0};
    }

    [[nodiscard]] glm::dvec3 corner(std::uint32_t c) const {
        return {transform_ * glm::dvec4{glm::dvec3{mesh_.positions[mesh_.indices[c]]}, 1.0}};
    }
    [[nodiscard]] std::array<glm::dvec3, 3> triangle(std::uint32_t t) const {
        return {corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)};
    }
    [[nodiscard]] std::uint32_t count() const { return static_cast<std::uint32_t>(mesh_.indices.size() / 3); }

private:
    const Mesh& mesh_;
    glm::dmat4 transform_;
};

}  // namespace inkedge::scene
