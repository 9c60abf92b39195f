#pragma once

#include <vector>

#include <inkedge/face_surfaces.h>

#include "formats/cad/surface_data.h"

namespace inkedge::cad {

/// Surfaces by their numbers: ISO 10303-42.
class CadSurfaces : public FaceSurfaces {
public:
    explicit CadSurfaces(std::vector<SurfaceData> surfaces) : surfaces_{std::move(surfaces)} {}

    [[nodiscard]] std::optional<SurfaceTriangle> under(const Mesh&, std::uint32_t triangle) const override;
    [[nodiscard]] SurfacePoint at(std::uint32_t face, glm::dvec3 parameters) const override;

private:
    std::vector<SurfaceData> surfaces_;
};

}  // namespace inkedge::cad
