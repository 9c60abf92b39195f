#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/scene.h>

#include "lines/find/border_segments.h"
#include "lines/segment.h"
#include "scene/scene_face.h"

namespace inkedge::lines {

/// The connected components of a scene's surface. Faces are connected across the edges that two of them share, and
/// instances across the seams between them.
class SurfaceComponents {
public:
    /// O(n).
    SurfaceComponents(const Scene&, std::span<const BorderSegment> borders);

    /// The number of a face's component.
    [[nodiscard]] std::uint32_t of(scene::SceneFace face) const noexcept {
        return components_[begins_[face.instance] + ofFaces_[meshes_[face.instance]][face.triangle]];
    }

    [[nodiscard]] bool areOne() const noexcept { return areOne_; }

    /// Whether a component other than that of a face may come near a point: so say their boxes, of up to
    /// manyComponents.
    /// @param point   world space less the middle of Scene::bounds()
    /// @param within  world units
    [[nodiscard]] bool mayBeNear(scene::SceneFace, glm::dvec3 point, double within) const noexcept;
    static constexpr std::size_t manyComponents = 32;

private:
    struct ComponentBox {
        std::uint32_t component;
        Box box;
    };
    void makeBoxes(const Scene&, std::span<const std::uint32_t> counts);

    std::vector<std::uint32_t> meshes_;                // one per instance
    std::vector<std::uint32_t> begins_;                // one per instance: where its components begin in components_
    std::vector<std::vector<std::uint32_t>> ofFaces_;  // one per mesh: the component of each face within the mesh
    std::vector<std::uint32_t> components_;
    std::vector<ComponentBox> boxes_;  // none: there are too many components
    bool areOne_;
};

/// How far faces may be nearer than a point without hiding it.
struct Slack {
    double length = 0.0;                            ///< world units
    const SurfaceComponents* components = nullptr;  ///< null: the slack is for every face; else for a component's
    std::uint32_t component = 0;
    [[nodiscard]] double of(scene::SceneFace face) const noexcept {
        return components == nullptr || components->of(face) == component ? length : 0.0;
    }
};

/// @param footprint  of a pixel at the segment
[[nodiscard]] inline Slack slackOf(const Segment& segment, double footprint,
                                   const SurfaceComponents* components) noexcept {
    if (segment.pixelSlack > 0.0) return {segment.pixelSlack * footprint};
    if (segment.slack == 0.0 || components == nullptr) return {segment.slack};
    return {segment.slack, components, components->of(segment.faces[0])};
}

}  // namespace inkedge::lines
