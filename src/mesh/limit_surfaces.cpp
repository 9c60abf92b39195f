#include "mesh/limit_surfaces.h"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/vec2.hpp>

#include "mesh/subdivision.h"
#include "modules/failure.h"

namespace inkedge::mesh {
namespace {

using Corners = std::array<glm::dvec2, 4>;  // of a triangle three

std::uint32_t trianglesOf(const ControlMesh& control, std::uint32_t face, int levels) {
    const std::uint32_t parts = 1U << static_cast<unsigned>(2 * levels);
    if (control.scheme == SubdivisionScheme::Loop) return parts;
    return 2U * parts / 4U * static_cast<std::uint32_t>(control.faceSizes[face]);
}

// A triangle's child at one of its corners, or in its middle, turned about.
Corners childOfTriangle(const Corners& of, std::uint32_t child) {
    const std::array middles{0.5 * (of[1] + of[2]), 0.5 * (of[2] + of[0]), 0.5 * (of[0] + of[1])};
    Corners corners{middles[0], middles[1], middles[2]};
    if (child == 3) return corners;
    for (std::uint32_t k = 0; k < 3; ++k) corners[k] = k == child ? of[child] : 0.5 * (of[k] + of[child]);
    return corners;
}

// A quad's child at one of its corners; its corners are in the quad's order.
Corners childOfQuad(const Corners& of, std::uint32_t child) {
    Corners corners{};
    for (std::uint32_t k = 0; k < 4; ++k) corners[k] = 0.5 * (of[k] + of[child]);
    return corners;
}

}  // namespace

std::vector<std::uint32_t> trianglesOfFaces(const ControlMesh& control, int levels) {
    std::vector<std::uint32_t> first(control.faceSizes.size());
    std::uint32_t count = 0;
    for (std::uint32_t f = 0; f < first.size(); ++f) {
        first[f] = count;
        count += trianglesOf(control, f, levels);
    }
    return first;
}

LimitSurfaces::LimitSurfaces(ControlMesh control, int levels, glm::dvec3 origin)
    : control_{std::move(control)},
      levels_{levels},
      origin_{origin},
      firstTriangles_{trianglesOfFaces(control_, levels)} {
    control_.coordinates = {};  // what is not of the surface
    control_.paint = {};
    control_.edges = {};
}

SurfaceTriangle LimitSurfaces::triangle(std::uint32_t number) const {
    const auto after = std::ranges::upper_bound(firstTriangles_, number);
    const auto face = static_cast<std::uint32_t>(after - firstTriangles_.begin()) - 1;
    std::uint32_t rest = number - firstTriangles_[face];
    const auto next = [&](int level) {  // of four children
        const auto shift = static_cast<unsigned>(2 * level);
        const std::uint32_t child = rest >> shift;
        rest -= child << shift;
        return child;
    };
    if (control_.scheme == SubdivisionScheme::Loop) {
        Corners corners{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}};
        for (int level = levels_ - 1; level >= 0; --level) corners = childOfTriangle(corners, next(level));
        return {face, {glm::dvec3{corners[0], 0.0}, glm::dvec3{corners[1], 0.0}, glm::dvec3{corners[2], 0.0}}};
    }
    const bool isSecond = rest % 2 != 0;  // of the two triangles of a quad
    rest /= 2;
    Corners corners{{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}};
    int level = levels_ - 1;
    const double quad = control_.faceSizes[face] == 4 ? 0.0 : next(level--);
    for (; level >= 0; --level) corners = childOfQuad(corners, next(level));
    const std::size_t second = isSecond ? 2 : 1;
    return {face,
            {glm::dvec3{corners[0], quad}, glm::dvec3{corners[second], quad}, glm::dvec3{corners[second + 1], quad}}};
}

std::optional<SurfaceTriangle> LimitSurfaces::under(const Mesh& mesh, std::uint32_t t) const {
    if (mesh.limitTriangles.empty()) return {};
    return triangle(mesh.limitTriangles[t]);
}

SurfacePoint LimitSurfaces::at(std::uint32_t face, glm::dvec3 parameters) const {
    std::call_once(isMade_, [&] {
        constexpr Error::Kind kind = Error::Kind::Runtime;
        surface_ =
            modules::expectNoFailure(modules::functionsOf<subdivisionModule>(kind).limit(control_), kind).surface;
    });
    SurfaceDerivatives point = surface_->at(face, static_cast<std::uint32_t>(parameters.z), glm::dvec2{parameters});
    point.position += origin_;
    return surfacePoint(point);
}

}  // namespace inkedge::mesh
