#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <glm/mat4x3.hpp>
#include <glm/vec3.hpp>

#include "modules/open_module.h"

// The interface between the library and the Embree module.

namespace inkedge::lines {

/// A segment: from + t * along, where begin <= t <= end.
struct Ray {
    glm::vec3 from;
    glm::vec3 along;
    float begin;
    float end;
};

struct RayHit {
    std::uint32_t instance;
    std::uint32_t triangle;  ///< of its mesh
    float at;                ///< t
};

/// Finds the triangles of instances that rays meet, from either side. A ray with a number that is not finite, or beyond
/// largestCoordinate, meets nothing; only its end may be infinite. Thread-safe.
class Rays {
public:
    Rays() = default;
    Rays(const Rays&) = delete;
    Rays& operator=(const Rays&) = delete;
    virtual ~Rays() = default;

    /// The first triangle that a ray meets, if it meets any.
    [[nodiscard]] virtual std::optional<RayHit> first(const Ray&) const noexcept = 0;
    [[nodiscard]] virtual bool meetsAny(const Ray&) const noexcept = 0;
};

/// Embree leaves out what lies beyond 1.8e18, silently.
inline constexpr float largestCoordinate = 1e18F;

/// The triangles of a mesh. Triangles that repeat another are left out: they would hide each other's edges.
struct RayMesh {
    std::span<const glm::vec3> positions;
    double scale;                              ///< of the positions, which it brings to about 1
    std::span<const std::uint32_t> indices;    ///< three per triangle
    std::span<const std::uint32_t> originals;  ///< MeshTopology::originals
};

struct RayInstance {
    std::uint32_t mesh;
    glm::mat4x3 transform;  ///< of the scaled positions
};

struct MadeRays {
    std::unique_ptr<Rays> rays;
    std::string failure;
};

struct RayMaker {
    /// Builds a bounding volume hierarchy for each mesh, and one for the instances. Keeps no reference to the
    /// arguments. An instance as thin as rounding, which no ray can be brought to, is left out.
    MadeRays (*make)(std::span<const RayMesh>, std::span<const RayInstance>);
};
inline constexpr modules::ModuleOf<RayMaker> embreeModule{{.purpose = "lines from object space",
                                                           .file = "inkedge_embree.so",
                                                           .symbol = "inkedge_embree_2",
                                                           .library = "Embree",
                                                           .option = "INKEDGE_EMBREE",
                                                           .remedy = "use --lines-from image"}};

}  // namespace inkedge::lines
