#pragma once

#include <functional>
#include <memory>
#include <span>

#include <inkedge/scene.h>

#include "lines/screen.h"
#include "lines/see/surface_components.h"
#include "lines/segment.h"

namespace inkedge::lines {

/// Rays from the eye through the scene's faces; both sides of a face stop them. Positions are world space less the
/// centre of Scene::bounds().
class RayCaster {
public:
    /// Builds a bounding volume hierarchy for each mesh, and one for the instances. The scene must outlive this.
    /// @throws Error  (Kind::Runtime) if Embree is not there or runs out of memory
    explicit RayCaster(const Scene&);
    ~RayCaster();
    RayCaster(const RayCaster&) = delete;
    RayCaster& operator=(const RayCaster&) = delete;

    /// Of a point's distance: a face must be nearer by more to hide the point.
    static constexpr double minStep = 1e-5;

    /// Whether a face lies between the near plane and a point. A face counts if it is nearer than the point by over
    /// minStep, computed in double precision.
    /// @param own    faces that do not count
    /// @param slack  how much nearer than that a face must be
    /// Thread-safe.
    [[nodiscard]] bool hides(const Screen&, glm::dvec3 point, std::span<const scene::SceneFace> own,
                             const Slack& slack = {}) const;

    /// Whether the ray through a point meets any face beyond the near plane, before or behind the point. Thread-safe.
    [[nodiscard]] bool meets(const Screen&, glm::dvec3 point) const;

    /// Whether any face between one point and another counts. Thread-safe.
    /// @param counts  called with a face and its unit normal, of either side; 0 if the face has none
    [[nodiscard]] bool meetsBetween(glm::dvec3 from, glm::dvec3 to,
                                    const std::function<bool(scene::SceneFace, glm::dvec3)>& counts) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace inkedge::lines
