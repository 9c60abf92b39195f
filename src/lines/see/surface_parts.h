#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/scene.h>

#include "lines/find/border_parts.h"
#include "lines/segment.h"
#include "scene/scene_face.h"

namespace inkedge::lines {

/// The parts of a scene's surface that hang together: faces across the edges that two of them share, and instances
/// across the seams between them.
class SurfaceParts {
public:
    /// O(n).
    SurfaceParts(const Scene&, std::span<const BorderPart> borders);

    /// A number that faces of one part share.
    [[nodiscard]] std::uint32_t of(SceneFace face) const noexcept {
        return parts_[begins_[face.instance] + ofFaces_[meshes_[face.instance]][face.triangle]];
    }

    [[nodiscard]] bool areOne() const noexcept { return areOne_; }

private:
    std::vector<std::uint32_t> meshes_;                // one an instance
    std::vector<std::uint32_t> begins_;                // one an instance: where its parts begin in parts_
    std::vector<std::vector<std::uint32_t>> ofFaces_;  // one a mesh: each face's part of it
    std::vector<std::uint32_t> parts_;
    bool areOne_;
};

/// How far faces of the part that a point lies on may be nearer than it without hiding it.
struct Slack {
    double length = 0.0;                  ///< in world units or pixels across, as the one who asks has it
    const SurfaceParts* parts = nullptr;  ///< null: every face has it
    std::uint32_t part = 0;
    [[nodiscard]] double of(SceneFace face) const noexcept {
        return parts == nullptr || parts->of(face) == part ? length : 0.0;
    }
};

[[nodiscard]] inline Slack slackOf(const Segment& segment, double length, const SurfaceParts* parts) noexcept {
    if (length == 0.0 || parts == nullptr) return {length};
    return {length, parts, parts->of(segment.faces[0])};
}

}  // namespace inkedge::lines
