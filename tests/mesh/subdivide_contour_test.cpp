#include "mesh/subdivide.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "mesh/control_meshes.h"
#include "mesh/topology.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

using namespace control_meshes;
using testing::IsEmpty;

struct Segment {
    glm::dvec3 a;
    glm::dvec3 b;
};

// Hertzmann 1999, section 3.3, equations 2 to 4.
template <class Normal, class Position>
std::vector<Segment> contour(std::size_t corners, glm::dvec3 eye, Position&& positionAt, Normal&& normalAt) {
    std::vector<Segment> segments;
    for (std::size_t c = 0; c < corners; c += 3) {
        std::vector<glm::dvec3> points;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t i = c + k;
            const std::size_t j = c + (k + 1) % 3;
            const double di = glm::dot(normalAt(i), glm::normalize(positionAt(i) - eye));
            const double dj = glm::dot(normalAt(j), glm::normalize(positionAt(j) - eye));
            if ((di < 0.0) == (dj < 0.0)) continue;
            const double sum = std::abs(di) + std::abs(dj);
            points.push_back(std::abs(dj) / sum * positionAt(i) + std::abs(di) / sum * positionAt(j));
        }
        if (points.size() == 2) segments.push_back({points[0], points[1]});
    }
    return segments;
}

std::vector<Segment> contour(const Mesh& mesh, glm::dvec3 eye) {
    return contour(
        mesh.indices.size(), eye, [&](std::size_t c) { return corner(mesh, c); },
        [&](std::size_t c) { return glm::dvec3{mesh.normals[mesh.indices[c]]}; });
}

constexpr glm::dvec3 eye{3.0, 1.0, 2.0};

template <class Error>
double greatestError(const std::vector<Segment>& contour, Error&& error) {
    EXPECT_FALSE(contour.empty());
    double greatest = 0.0;
    for (const Segment& s : contour) greatest = std::max({greatest, error(s.a), error(s.b)});
    return greatest;
}

// How far a point of a contour is off the unit sphere's, which lies in the plane p . eye = 1.
double offSphere(glm::dvec3 p) {
    return std::max(std::abs(glm::length(p) - 1.0), std::abs(glm::dot(p, eye) - 1.0) / glm::length(eye));
}

// How far it is off the torus, or, as an angle, from where the torus turns away.
double offTorus(glm::dvec3 p) {
    const glm::dvec3 middle = torusRadius * glm::normalize(glm::dvec3{p.x, p.y, 0.0});
    const double distance = glm::distance(p, middle);
    const double turn = glm::dot((p - middle) / distance, glm::normalize(p - eye));
    return std::max(std::abs(distance - tubeRadius), std::abs(turn));
}

// The control mesh is within O(h^2) of the surface that its vertices lie on, and so is its limit: halving h quarters
// the error. From 3.5 to 4.5 is what terms of higher order leave at these sizes.

TEST(Subdivide, convergesToTheAnalyticContourAtSecondOrder) {
    std::vector<double> sphere;
    std::vector<double> loop;
    std::vector<double> catmullClark;
    for (const std::uint32_t n : {1U, 2U, 4U}) {
        const LoadSettings settings = levels(2, smoothAngle);
        sphere.push_back(greatestError(contour(refined(ball(6 * n), settings).meshes()[0], eye), offSphere));
        const Mesh control = torus(32 * n, 16 * n);
        catmullClark.push_back(greatestError(contour(refined(control, settings).meshes()[0], eye), offTorus));
        loop.push_back(greatestError(contour(refined(asTriangles(control), settings).meshes()[0], eye), offTorus));
    }
    for (const auto& errors : {sphere, loop, catmullClark}) {
        for (std::size_t i = 1; i < errors.size(); ++i) {
            EXPECT_GT(errors[i - 1] / errors[i], 3.5) << errors[i - 1] << " then " << errors[i];
            EXPECT_LT(errors[i - 1] / errors[i], 4.5) << errors[i - 1] << " then " << errors[i];
        }
    }
}

double distanceTo(const Segment& s, glm::dvec3 p) {
    const glm::dvec3 along = s.b - s.a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0.0 ? std::clamp(glm::dot(p - s.a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(p, s.a + t * along);
}

// One control mesh: each level halves the edges, so the contour's root mean square distance from the limit's quarters.
// Level 5 stands for the limit: a 16th of level 3's error. Two levels make 16, give or take the coarse start.
TEST(Subdivide, eachLevelQuartersTheDistanceFromTheLimitsContour) {
    for (const Mesh& control : {torus(12, 8), asTriangles(torus(12, 8)), ball(2)}) {
        const std::vector<Segment> limit = contour(refined(control, levels(5, smoothAngle)).meshes()[0], eye);
        std::vector<double> errors;
        for (int n = 1; n <= 3; ++n) {
            double sum = 0.0;
            const std::vector<Segment> found = contour(refined(control, levels(n, smoothAngle)).meshes()[0], eye);
            for (const Segment& f : found) {
                double nearest = 1e9;
                for (const Segment& s : limit) nearest = std::min(nearest, distanceTo(s, 0.5 * (f.a + f.b)));
                sum += nearest * nearest;
            }
            errors.push_back(std::sqrt(sum / static_cast<double>(found.size())));
        }
        EXPECT_GT(errors[0] / errors[2], 10.0) << errors[0] << ' ' << errors[1] << ' ' << errors[2];
        EXPECT_LT(errors[0] / errors[2], 24.0) << errors[0] << ' ' << errors[1] << ' ' << errors[2];
    }
}

struct AdaptiveCase {
    Mesh control;
    double creaseAngle;
    Projection projection;
};

std::vector<AdaptiveCase> adaptiveCases() {
    Mesh far = torus(16, 10);
    far.origin = {0.25, 0.0, 0.5};
    return {{torus(16, 10), smoothAngle, Projection::Perspective},
            {asTriangles(torus(16, 10)), smoothAngle, Projection::Perspective},
            {asTriangles(torus(16, 10)), 25.0, Projection::Perspective},  // creases along some edges
            {torus(16, 10), 25.0, Projection::Orthographic},
            {far, smoothAngle, Projection::Perspective},
            {grid(4), 30.0, Projection::Perspective},
            {ball(3), smoothAngle, Projection::Orthographic},
            {quadCube(), smoothAngle, Projection::Perspective}};
}

// Triangles of the uniformly refined mesh that come from one triangle of the control mesh, in their order.
std::size_t blockOf(const ControlMesh& control, std::uint32_t triangle, std::size_t perFace) {
    return control.faces[triangle] * perFace;
}

ControlMesh controlOf(const Scene& scene) { return controlMesh(scene.meshes()[0], scene::topologyOf(scene, 0)); }

TEST(RefineNear, givesWhatUniformRefinementGivesThere) {
    for (const AdaptiveCase& c : adaptiveCases()) {
        const Scene scene = refined(c.control, levels(0, c.creaseAngle));
        const ControlMesh control = controlOf(scene);
        for (const int n : {1, 3}) {
            const Scene uniformScene = refined(c.control, levels(n, c.creaseAngle));
            const Mesh& uniform = uniformScene.meshes()[0];
            const RefinedContourMesh near = refineNear(scene.meshes()[0], control, eye, c.projection, n);
            const std::size_t perFace = uniform.indices.size() / 3 / control.faceSizes.size();
            ASSERT_EQ(near.controlTriangles.size() * 3, near.indices.size());
            ASSERT_EQ(near.controlTriangles.size() % perFace, 0U);
            for (std::size_t t = 0; t < near.controlTriangles.size(); ++t) {
                const std::size_t same = blockOf(control, near.controlTriangles[t], perFace) + t % perFace;
                for (std::size_t k = 0; k < 3; ++k) {
                    const std::uint32_t vertex = near.indices[3 * t + k];
                    const std::uint32_t theirs = uniform.indices[3 * same + k];
                    // A float of size 1 is rounded by 6e-8.
                    ASSERT_LT(glm::distance(near.positions[vertex], glm::dvec3{uniform.positions[theirs]}), 2e-7);
                    ASSERT_LT(glm::distance(near.normals[vertex], glm::dvec3{uniform.normals[theirs]}), 2e-7);
                }
            }
        }
    }
}

TEST(RefineNear, holdsTheWholeContourOfTheSmoothSurface) {
    for (const AdaptiveCase& c : adaptiveCases()) {
        if (c.projection != Projection::Perspective) continue;
        const Scene scene = refined(c.control, levels(0, c.creaseAngle));
        const Scene uniform = refined(c.control, levels(4, c.creaseAngle));
        const RefinedContourMesh near = refineNear(scene.meshes()[0], controlOf(scene), eye, c.projection, 4);
        const std::vector<Segment> found = contour(
            near.indices.size(), eye - c.control.origin, [&](std::size_t i) { return near.positions[near.indices[i]]; },
            [&](std::size_t i) { return near.normals[near.indices[i]]; });
        EXPECT_EQ(found.size(), contour(uniform.meshes()[0], eye - c.control.origin).size());
    }
}

TEST(RefineNear, leavesAloneWhatTheContourIsFarFrom) {
    const Scene scene = refined(asTriangles(torus(64, 32)), levels(0));
    const ControlMesh control = controlOf(scene);
    const std::vector<std::uint32_t> triangles =
        refineNear(scene.meshes()[0], control, eye, Projection::Perspective, 1).controlTriangles;
    const std::set<std::uint32_t> faces(triangles.begin(), triangles.end());
    EXPECT_GT(faces.size(), 100U);
    EXPECT_LT(faces.size(), control.faceSizes.size() / 3);

    const Scene sheet = refined(grid(4), levels(0));
    EXPECT_THAT(refineNear(sheet.meshes()[0], controlOf(sheet), eye, Projection::Perspective, 2).indices, IsEmpty());
    // Zero counts as plus: an edge-on sheet has one sign.
    EXPECT_THAT(refineNear(sheet.meshes()[0], controlOf(sheet), {1.0, 0.0, 0.0}, Projection::Orthographic, 2).indices,
                IsEmpty());
}

}  // namespace
}  // namespace inkedge::mesh
