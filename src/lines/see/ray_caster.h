#pragma once

#include <memory>
#include <optional>
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

    /// Whether a face lies between the near plane and a point. A face counts if it is nearer than the point by over
    /// 1e-5 of the point's distance, computed in double precision.
    /// @param own    faces that do not count
    /// @param slack  how much nearer than that a face must be
    /// Thread-safe.
    [[nodiscard]] bool hides(const Screen&, glm::dvec3 point, std::span<const scene::SceneFace> own,
                             const Slack& slack = {}) const;

    /// Whether the ray through a point meets any face beyond the near plane, before or behind the point. Thread-safe.
    [[nodiscard]] bool meets(const Screen&, glm::dvec3 point) const;

    /// The normal, of either side, of the first face between one point and another. Thread-safe.
    /// @param own  faces that do not count
    [[nodiscard]] std::optional<glm::dvec3> firstNormal(glm::dvec3 from, glm::dvec3 to,
                                                        std::span<const scene::SceneFace> own) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace inkedge::lines
