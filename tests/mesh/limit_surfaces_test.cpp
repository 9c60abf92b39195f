// The limit surface under the triangles of subdivided meshes.
#include "mesh/limit_surfaces.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "mesh/control_meshes.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

using namespace control_meshes;

// A prism: its ends are polygons of five corners.
Mesh prism() {
    Mesh mesh;
    for (const double z : {-1.0, 1.0}) {
        for (int i = 0; i < 5; ++i) {
            const double angle = 2.0 * std::numbers::pi * i / 5.0;
            mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
        }
    }
    for (std::uint32_t i = 0; i < 5; ++i) addQuad(mesh, i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5);
    constexpr EdgeKinds outer;
    constexpr EdgeKinds inner = EdgeKind::Inner;
    mesh.indices.insert(mesh.indices.end(), {0, 2, 1, 0, 3, 2, 0, 4, 3, 5, 6, 7, 5, 7, 8, 5, 8, 9});
    mesh.edges.insert(mesh.edges.end(), {inner, outer, outer, inner, outer, inner, outer, outer, inner, outer, outer,
                                         inner, inner, outer, inner, inner, outer, outer});
    return mesh;
}

struct Case {
    std::string name;
    Mesh control;
    double creaseAngle;
};

std::vector<Case> cases() {
    Mesh far = torus(9, 6);
    far.origin = {100.0, -20.0, 3.0};
    return {{"cube", quadCube(), smoothAngle},
            {"cube with creases", quadCube(), 30.0},
            {"cube of triangles", asTriangles(quadCube()), smoothAngle},
            {"torus", torus(9, 6), smoothAngle},
            {"torus far off", far, smoothAngle},
            {"torus of triangles", asTriangles(torus(9, 6)), smoothAngle},
            {"torus with creases", asTriangles(torus(9, 6)), 25.0},
            {"sheet", grid(3), 30.0},
            {"sheet of triangles", asTriangles(grid(3)), 30.0},
            {"prism", prism(), smoothAngle},
            {"prism with creases", prism(), 80.0},
            {"prism of triangles", asTriangles(prism()), smoothAngle}};
}

TEST(LimitSurfaces, passThroughTheVerticesOfAllLevels) {
    constexpr double rounding = 3e-7;  // of floats of size 1
    for (const Case& c : cases()) {
        for (const int n : {1, 2, 3}) {
            SCOPED_TRACE(c.name + std::to_string(n));
            const Scene scene = refined(c.control, levels(n, c.creaseAngle));
            const Mesh& mesh = scene.meshes()[0];
            ASSERT_NE(mesh.surfaces, nullptr);
            for (std::uint32_t i = 0; i < mesh.indices.size(); ++i) {
                const auto part = mesh.surfaces->under(mesh, i / 3);
                ASSERT_TRUE(part);
                const SurfacePoint point = mesh.surfaces->at(part->face, part->corners[i % 3]);
                ASSERT_LT(glm::distance(point.position - mesh.origin, corner(mesh, i)), rounding);
                const glm::dvec3 normal{mesh.normals[mesh.indices[i]]};
                if (glm::length(point.normal) > 1e-3) {  // in a corner there is none
                    ASSERT_GT(std::abs(glm::dot(glm::normalize(point.normal), normal)), 1.0 - rounding);
                }
            }
        }
    }
}

TEST(LimitSurfaces, haveTheirDerivatives) {
    constexpr double step = 1e-5;
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const Scene scene = refined(c.control, levels(1, c.creaseAngle));
        const Mesh& mesh = scene.meshes()[0];
        for (std::uint32_t t = 0; t < mesh.indices.size() / 3; ++t) {
            const auto part = mesh.surfaces->under(mesh, t);
            const glm::dvec3 middle = 0.2 * part->corners[0] + 0.35 * part->corners[1] + 0.45 * part->corners[2];
            const auto at = [&](glm::dvec3 by) { return mesh.surfaces->at(part->face, middle + by); };
            const SurfacePoint point = at({0, 0, 0});
            const SurfacePoint rightOf = at({step, 0, 0});
            const SurfacePoint leftOf = at({-step, 0, 0});
            const SurfacePoint above = at({0, step, 0});
            const SurfacePoint below = at({0, -step, 0});
            const auto expectDerivative = [&](glm::dvec3 found, glm::dvec3 difference) {
                ASSERT_LT(glm::distance(found, difference / (2.0 * step)), 1e-5);
            };
            expectDerivative(point.du, rightOf.position - leftOf.position);
            expectDerivative(point.dv, above.position - below.position);
            expectDerivative(point.normalDu, rightOf.normal - leftOf.normal);
            expectDerivative(point.normalDv, above.normal - below.normal);
        }
    }
}

}  // namespace
}  // namespace inkedge::mesh
