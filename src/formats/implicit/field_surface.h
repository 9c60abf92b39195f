#pragma once

#include <memory>
#include <utility>

#include <inkedge/face_surfaces.h>

#include "formats/implicit/scalar_field.h"

namespace inkedge::implicit {

/// The surface where a field is 0. It has no parameters of its own: these are positions near it, in which u and v are
/// lengths along the surface.
class FieldSurface : public FaceSurfaces {
public:
    /// @param step  over which differences stand for derivatives
    FieldSurface(std::shared_ptr<const ScalarField> field, double step) : field_{std::move(field)}, step_{step} {}

    [[nodiscard]] std::optional<SurfaceTriangle> under(const Mesh&, std::uint32_t triangle) const override;
    /// The point of the surface that lies in the direction of the field's gradient.
    [[nodiscard]] SurfacePoint at(std::uint32_t face, glm::dvec3 parameters) const override;
    [[nodiscard]] glm::dvec3 moved(glm::dvec3 parameters, const SurfacePoint&, glm::dvec2 step) const override;

private:
    struct Local;
    [[nodiscard]] Local localAt(glm::dvec3 position) const;

    std::shared_ptr<const ScalarField> field_;
    double step_;
};

}  // namespace inkedge::implicit
