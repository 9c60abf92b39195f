#include <inkedge/error.h>

#include "lines/see/ray_caster.h"

namespace inkedge::lines {

struct RayCaster::State {};

RayCaster::RayCaster(const Scene&) {
    throw Error{Error::Kind::Runtime,
                "lines from object space: expected a build with Embree, found one without; build with "
                "INKEDGE_EMBREE=ON, or use --lines-from image"};
}
RayCaster::~RayCaster() = default;
bool RayCaster::hides(const Screen&, glm::dvec3, std::span<const SceneFace>, const Slack&) const { return false; }
std::optional<glm::dvec3> RayCaster::firstNormal(glm::dvec3, glm::dvec3, std::span<const SceneFace>) const {
    return {};
}
bool RayCaster::meets(const Screen&, glm::dvec3) const { return false; }

}  // namespace inkedge::lines
