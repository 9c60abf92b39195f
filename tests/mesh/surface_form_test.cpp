#include "mesh/surface_form.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "mesh/curved_shapes.h"
#include "mesh/shapes.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

constexpr double edgesAlone = 1e-6;  // a feature size under any edge's length: smoothed over that

struct Formed {
    Scene scene;
    SurfaceForm form;
    explicit Formed(const Mesh& mesh, double featureSize = edgesAlone)
        : scene{scenes::sceneOf(mesh)},
          form{surfaceForm(scene.meshes()[0], scene::topologyOf(scene, 0), featureSize)} {}

    // Calls visit(position, form at the position) for each corner. Lengths are in the mesh's unit again.
    template <class Visit>
    void forEach(Visit visit) const {
        const Mesh& mesh = scene.meshes()[0];
        const MeshTopology& topology = scene::topologyOf(scene, 0);
        for (std::size_t c = 0; c < mesh.indices.size(); ++c) {
            const auto size = static_cast<float>(form.featureSizes[topology.patches[c / 3]]);
            PointForm point = form.points[form.fans[c]];
            for (float& k : point.curvatures) k /= size;
            for (float& d : point.derivative) d /= size * size;
            visit(glm::dvec3{mesh.positions[mesh.indices[c]]} + mesh.origin, point);
        }
    }
};

double longestEdge(const Mesh& mesh) {
    double longest = 0.0;
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3)
        for (std::size_t k = 0; k < 3; ++k)
            longest =
                std::max(longest, static_cast<double>(glm::distance(mesh.positions[mesh.indices[t + k]],
                                                                    mesh.positions[mesh.indices[t + (k + 1) % 3]])));
    return longest;
}

// What 19 of 20 are under: points with other than six neighbours have normals that are off by more.
double nearlyAll(std::vector<double> values) {
    const auto high = values.begin() + static_cast<std::ptrdiff_t>(0.95 * static_cast<double>(values.size()));
    std::nth_element(values.begin(), high, values.end());
    return *high;
}

// How far the tensor and its derivative are off on an ellipsoid.
struct Off {
    double tensor;
    double derivative;
};
Off offOnEllipsoid(const Mesh& mesh, const curved::EllipsoidAt& truth, double featureSize) {
    std::vector<double> tensors;
    std::vector<double> derivatives;
    Formed{mesh, featureSize}.forEach([&](glm::dvec3 p, const PointForm& form) {
        const glm::dvec3 first{form.first};
        const glm::dvec3 second = glm::cross(glm::dvec3{form.normal}, first);
        const glm::dmat3 tensor = truth.tensor(p);
        tensors.push_back(
            std::max({std::abs(glm::dot(first, tensor * first) - static_cast<double>(form.curvatures[0])),
                      std::abs(glm::dot(second, tensor * second) - static_cast<double>(form.curvatures[1])),
                      std::abs(glm::dot(first, tensor * second))}));
        const auto off = [&](std::size_t component, glm::dvec3 x, glm::dvec3 y, glm::dvec3 z) {
            return std::abs(truth.derivative(p, x, y, z) - static_cast<double>(form.derivative[component]));
        };
        derivatives.push_back(std::max({off(0, first, first, first), off(1, first, first, second),
                                        off(2, first, second, second), off(3, second, second, second)}));
    });
    return {nearlyAll(tensors), nearlyAll(derivatives)};
}

TEST(SurfaceForm, ofAnEllipsoidIsItsCurvatureTensorAndDerivative) {
    const curved::EllipsoidAt truth{{1.5, 1.0, 0.7}};
    const double sharpest = 1.5 / (0.7 * 0.7);  // curvature
    for (const int n : {24, 48}) {
        const Mesh mesh = curved::ellipsoid(truth.axes, n);
        // Linear normals, and smoothing over an edge's length, are off by the square of that length, as the curvature
        // is; its derivative, of values on both sides of faces, by the length itself.
        const double edge = longestEdge(mesh) * sharpest;
        const Off off = offOnEllipsoid(mesh, truth, edgesAlone);
        EXPECT_LT(off.tensor, 0.5 * edge * edge * sharpest) << n;
        EXPECT_LT(off.derivative, 0.5 * edge * sharpest * sharpest) << n;
    }
}

TEST(SurfaceForm, ofASphereIsOneOverItsRadiusBothWays) {
    for (const double radius : {0.001, 1.0, 1000.0}) {
        const Mesh mesh = curved::ellipsoid(glm::dvec3{radius}, 24);
        const Formed sphere{mesh, 0.02};
        // The area of the mesh is that of the sphere, less a share of the square of the angle of an edge.
        EXPECT_NEAR(sphere.form.featureSizes[0] / radius, 0.02, 0.02 * 0.005);
        const double spread = sphere.form.resolutions[0] / radius;
        sphere.forEach([&](glm::dvec3, const PointForm& form) {
            // Where planes turn by an angle, the mean of curvatures in the world is less by its square.
            for (const float k : form.curvatures)
                EXPECT_NEAR(static_cast<double>(k) * radius, 1.0 - spread * spread, spread * spread);
            // Differences of such means, at points that have fewer neighbours on one side.
            for (const float d : form.derivative) EXPECT_NEAR(static_cast<double>(d) * radius * radius, 0.0, spread);
        });
    }
}

// Walls of triangles that reach from lid to lid have no point that is not at a crease.
TEST(SurfaceForm, endsAtCreases) {
    const Formed formed{prism(90, 0.5)};
    const double spread = formed.form.resolutions[0];  // as on a sphere
    formed.forEach([&](glm::dvec3, const PointForm& form) {
        if (std::abs(form.normal.y) > 0.5F)
            EXPECT_NEAR(static_cast<double>(form.curvatures[0]), 0.0, 1e-3);
        else
            EXPECT_NEAR(static_cast<double>(form.curvatures[0]), 1.0 - spread * spread, spread * spread);
        EXPECT_NEAR(static_cast<double>(form.curvatures[1]), 0.0, 1e-3);
    });
}

// A sheet that is cut where it bends: normals at the border are those of faces to one side.
TEST(SurfaceForm, ofAnArchIsTheSameUpToItsBorder) {
    const Mesh arch = curved::sheet(40, [](double x, double) { return std::sqrt(4.0 - x * x); });
    const double edge = longestEdge(arch);
    Formed{arch}.forEach([&](glm::dvec3 p, const PointForm& form) {
        EXPECT_NEAR(static_cast<double>(form.curvatures[0]), 0.5, edge) << p.x << ' ' << p.y;
        EXPECT_NEAR(static_cast<double>(form.derivative[0]), 0.0, edge) << p.x << ' ' << p.y;
    });
}

TEST(SurfaceForm, ofARoughSphereIsNearlyThatOfASmoothOne) {
    Mesh rough = curved::ellipsoid(glm::dvec3{1.0}, 64);
    for (glm::vec3& p : rough.positions) {  // by the position, for some positions are there several times
        const double noise = std::sin(1e4 * static_cast<double>(p.x)) * std::sin(1.3e4 * static_cast<double>(p.y)) *
                             std::sin(1.7e4 * static_cast<double>(p.z));
        p *= 1.0F + static_cast<float>(0.003 * noise);
    }
    const auto offOf = [&](double featureSize) {
        std::vector<double> off;
        Formed{rough, featureSize}.forEach([&](glm::dvec3, const PointForm& form) {
            off.push_back(std::abs(static_cast<double>(form.curvatures[0]) - 1.0));
        });
        return nearlyAll(off);
    };
    const double overEdges = offOf(edgesAlone);
    EXPECT_GT(overEdges, 0.25);  // bumps of 0.003 on edges of 0.03
    EXPECT_LT(offOf(0.1), 0.25 * overEdges);
}

TEST(SurfaceForm, ofAMeshWithoutAreaIsNothing) {
    EXPECT_TRUE(surfaceForm({}, {}, 0.02).points.empty());
    Mesh thin;
    thin.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    thin.indices = {0, 1, 2};
    const Formed none{thin};
    for (const PointForm& point : none.form.points) EXPECT_EQ(point.curvatures[0], 0.0F);
}

}  // namespace
}  // namespace inkedge::mesh
