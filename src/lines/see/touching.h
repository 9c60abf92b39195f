#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include <inkedge/scene.h>

#include "lines/screen.h"
#include "lines/see/ray_caster.h"
#include "lines/see/surface_components.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// What another surface, no further from a face's plane than touchingWithin and bent by less than the crease angle,
/// does at the face's edge.
enum class Touch : std::uint8_t {
    None,    ///< there is none
    Begins,  ///< it goes on where the face ends
    RunsOn,  ///< it lies on the face, too
};

inline constexpr double touchingWithin = 0.1;  ///< pixels

/// Where surfaces touch others. What it is made of must outlive it. Thread-safe.
class Touching {
public:
    /// @param components  null: the scene is one component
    Touching(const Scene& scene, const RayCaster& rays, const SurfaceComponents* components, const Screen& screen);

    /// At a point of a boundary. Where another surface begins there, it may be of the same component.
    [[nodiscard]] Touch atBorder(const Segment&, glm::dvec3 point) const;

    /// Whether an edge lies in a face of another component, behind which all of the edge's faces lie: these touch that
    /// face from behind, and nothing of them is seen there.
    [[nodiscard]] bool isBehindFace(const Segment&, glm::dvec3 point) const;

    /// Whether another component goes on beyond either face of an edge.
    [[nodiscard]] bool atEdge(const Segment&, glm::dvec3 point) const;

private:
    struct Edge;
    enum class Which { Any, OtherComponents };

    [[nodiscard]] double withinAt(glm::dvec3 point) const;  // world units
    [[nodiscard]] Edge edgeOf(const Segment&, scene::SceneFace, glm::dvec3 point) const;
    [[nodiscard]] bool goesOn(const Segment&, const Edge&, glm::dvec3 beside, Which) const;

    [[nodiscard]] bool isBelow(const Segment&, const Edge&, glm::dvec3 point) const;

    const Scene& scene_;
    const RayCaster& rays_;
    const SurfaceComponents* components_;
    const Screen& screen_;
    double creaseCosine_;
};

}  // namespace inkedge::lines
