#include "camera/drawn_part.h"

#include <array>
#include <cstdint>

#include "base/stop.h"
#include "scene/extent.h"

namespace inkedge::camera {
namespace {

// Adds what a camera sees of points in view space to a part of its picture.
class Projector {
public:
    Projector(const Camera& camera, Size size)
        : orthographic_{camera.orthographic()},
          focalLengths_{camera.focalLengths(size)},
          near_{camera.near},
          centre_{camera.axis * 0.5 * glm::dvec2{size.width, size.height}} {}

    [[nodiscard]] bool sees(glm::dvec3 point) const noexcept { return orthographic_ || -point.z >= near_; }

    void add(glm::dvec3 point) noexcept {
        part_.add(centre_ + focalLengths_ * glm::dvec2{point} / (orthographic_ ? 1.0 : -point.z));
    }

    // Of a triangle, what lies before the near plane.
    void addTriangle(const std::array<glm::dvec3, 3>& corners) noexcept {
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3 a = corners[i];
            const glm::dvec3 b = corners[(i + 1) % 3];
            if (sees(a)) add(a);
            if (sees(a) != sees(b)) {
                const glm::dvec3 cut = a + (-near_ - a.z) / (b.z - a.z) * (b - a);
                add(glm::dvec3{cut.x, cut.y, -near_});
            }
        }
    }

    [[nodiscard]] const PicturePart& part() const noexcept { return part_; }

private:
    bool orthographic_;
    glm::dvec2 focalLengths_;
    double near_;
    glm::dvec2 centre_;
    PicturePart part_;
};

}  // namespace

PicturePart drawnPart(const Scene& scene, const Camera& camera, Size size) {
    Projector projector{camera, size};
    scene::forEachInstance(scene, [&](const Instance& instance, const Mesh& mesh) {
        base::stopIfAsked();
        const glm::dmat4 toView = camera.view * instance.transform;
        const auto inView = [&](std::uint32_t vertex) {
            return glm::dvec3{toView * glm::dvec4{glm::dvec3{mesh.positions[vertex]} + mesh.origin, 1.0}};
        };
        bool allSeen = true;
        for (std::uint32_t v = 0; v < mesh.positions.size() && allSeen; ++v) allSeen = projector.sees(inView(v));
        if (allSeen) {
            for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) projector.add(inView(v));
            return;
        }
        for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3)
            projector.addTriangle({inView(mesh.indices[t]), inView(mesh.indices[t + 1]), inView(mesh.indices[t + 2])});
    });
    return projector.part();
}

}  // namespace inkedge::camera
