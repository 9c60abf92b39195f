#include "mesh/normals.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/connect.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;

// Normals are doubles of order 1 stored as floats: each component is off by at most half of 2^-24.
constexpr float asFloat = 1e-6F;

void expectNear(glm::vec3 found, glm::dvec3 expected, float tolerance = asFloat) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
}

glm::vec3 cornerNormal(const Mesh& mesh, std::size_t corner) { return mesh.normals[mesh.indices[corner]]; }
glm::vec3 cornerPosition(const Mesh& mesh, std::size_t corner) { return mesh.positions[mesh.indices[corner]]; }

LoadSettings with(Normals normals, double creaseAngle = 30.0) { return {normals, Creases::Auto, creaseAngle}; }

Mesh completed(Mesh mesh, const LoadSettings& settings) {
    (void)connect(mesh, settings);
    return mesh;
}

// Two unit squares that share the edge x = 0 and bend by an angle about it: corners 0 to 5 and 6 to 11.
Mesh fold(double degrees) {
    const double a = glm::radians(degrees);
    const glm::dvec3 left{-1, 0, 0};
    const glm::dvec3 right{std::cos(a), 0, -std::sin(a)};
    Mesh mesh;
    for (const glm::dvec3& p :
         {left, glm::dvec3{0}, glm::dvec3{0, 1, 0}, left + glm::dvec3{0, 1, 0}, right, right + glm::dvec3{0, 1, 0}}) {
        mesh.positions.emplace_back(p);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    return mesh;
}

glm::dvec3 rightNormal(double degrees) { return {std::sin(glm::radians(degrees)), 0, std::cos(glm::radians(degrees))}; }

void expectUnitNormals(const Mesh& mesh) {
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    for (const glm::vec3 n : mesh.normals) EXPECT_NEAR(glm::length(n), 1.0F, asFloat);
}

TEST(CompleteNormals, splitsAtTheCreaseAngle) {
    // Over a degree is beyond doubt; float positions give the bend within 1e-5 degrees.
    const Mesh smooth = completed(fold(40.0), with(Normals::Auto, 39.01));
    EXPECT_EQ(smooth.positions.size(), 6U);
    expectNear(cornerNormal(smooth, 1), rightNormal(20.0));
    expectNear(cornerNormal(smooth, 6), rightNormal(20.0));

    const Mesh split = completed(fold(40.0), with(Normals::Auto, 38.99));
    EXPECT_EQ(split.positions.size(), 8U);
    for (std::size_t corner = 0; corner < 6; ++corner) expectNear(cornerNormal(split, corner), {0, 0, 1});
    for (std::size_t corner = 6; corner < 12; ++corner) expectNear(cornerNormal(split, corner), rightNormal(40.0));
}

TEST(CompleteNormals, splitsABendToEitherSideAlike) {
    for (const double degrees : {-40.0, 40.0}) {
        EXPECT_EQ(completed(fold(degrees), with(Normals::Auto, 41.0)).positions.size(), 6U);
        EXPECT_EQ(completed(fold(degrees), with(Normals::Auto, 38.0)).positions.size(), 8U);
    }
}

TEST(CompleteNormals, keepsFlatWhatDoesNotBendAtACreaseAngleOfZero) {
    const Mesh flat = completed(fold(0.0), with(Normals::Auto, 0.0));
    for (std::size_t corner = 0; corner < 12; ++corner) expectNear(cornerNormal(flat, corner), {0, 0, 1});
}

TEST(CompleteNormals, smoothsAcrossEveryBendAtACreaseAngleOf180) {
    EXPECT_EQ(completed(scenes::cube(), with(Normals::Auto, 180.0)).positions.size(), 8U);
}

TEST(CompleteNormals, weighsFacesByTheirCornersAngle) {
    // However its faces are cut into triangles, a cube's corner points along the diagonal.
    const Mesh cube = completed(scenes::cube(2.0), with(Normals::Auto, 180.0));
    for (std::size_t corner = 0; corner < cube.indices.size(); ++corner) {
        expectNear(cornerNormal(cube, corner), glm::normalize(glm::dvec3{cornerPosition(cube, corner)}));
    }
}

TEST(CompleteNormals, givesACubeItsSixFaces) {
    const Mesh cube = completed(scenes::cube(), with(Normals::Auto));
    EXPECT_EQ(cube.positions.size(), 24U);
    for (std::size_t corner = 0; corner < cube.indices.size(); ++corner) {
        const glm::vec3 n = cornerNormal(cube, corner);
        EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1.0F, asFloat);
        EXPECT_NEAR(glm::dot(n, cornerPosition(cube, corner)), 1.0F, asFloat) << "outward";
    }
}

TEST(CompleteNormals, givesASphereRadialNormals) {
    Mesh sphere = scenes::sphere(3.0, 64);
    sphere.normals.clear();
    const Mesh made = completed(sphere, with(Normals::Auto));
    expectUnitNormals(made);
    for (std::size_t corner = 0; corner < made.indices.size(); ++corner) {
        // Facets are 5.6 degrees wide: the mean of the faces around a vertex is within a fraction of one of them. The
        // seam of doubled positions and the poles are no exception.
        EXPECT_GT(glm::dot(cornerNormal(made, corner), glm::normalize(cornerPosition(made, corner))),
                  std::cos(glm::radians(0.5)));
    }
}

TEST(CompleteNormals, smoothsAcrossVerticesAtOnePosition) {
    Mesh split;
    const Mesh shared = fold(20.0);
    for (const std::uint32_t i : shared.indices) {
        split.indices.push_back(static_cast<std::uint32_t>(split.positions.size()));
        split.positions.push_back(shared.positions[i]);
    }
    const Mesh made = completed(split, with(Normals::Auto));
    expectNear(cornerNormal(made, 1), rightNormal(10.0));
    expectNear(cornerNormal(made, 6), rightNormal(10.0));
    EXPECT_EQ(made.positions.size(), 6U) << "one vertex per position and normal";
}

TEST(CompleteNormals, keepsApartWhatOnlyTouchesInAPoint) {
    // Two triangles in one plane but for a small bend, joined at the origin alone.
    Mesh bowTie;
    bowTie.positions = {{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, -0.1F}, {-1, -1, -0.1F}};
    bowTie.indices = {0, 1, 2, 0, 3, 4};
    const Mesh made = completed(bowTie, with(Normals::Auto));
    EXPECT_EQ(made.positions.size(), 6U);
    expectNear(cornerNormal(made, 0), {0, 0, 1});
}

TEST(CompleteNormals, keepsApartTheFacesOfAnEdgeThatThreeShare) {
    Mesh fin = fold(10.0);
    fin.positions.emplace_back(0.0F, 0.5F, 1.0F);
    fin.indices.insert(fin.indices.end(), {1, 2, 6});
    const Mesh made = completed(fin, with(Normals::Auto));
    expectNear(cornerNormal(made, 1), {0, 0, 1});
    expectNear(cornerNormal(made, 6), rightNormal(10.0));
}

TEST(CompleteNormals, keepsApartFacesThatAreWoundAgainstEachOther) {
    Mesh mesh = fold(10.0);
    for (std::size_t t = 6; t < 12; t += 3) std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
    const Mesh made = completed(mesh, with(Normals::Auto));
    for (std::size_t corner = 0; corner < 6; ++corner) expectNear(cornerNormal(made, corner), {0, 0, 1});
    for (std::size_t corner = 6; corner < 12; ++corner) expectNear(cornerNormal(made, corner), -rightNormal(10.0));
}

TEST(CompleteNormals, keepsTheFilesNormals) {
    Mesh mesh = fold(20.0);
    const glm::vec3 odd = glm::normalize(glm::vec3{0.15F, 0.05F, 1.0F});  // within ten degrees of both faces
    mesh.normals.assign(mesh.positions.size(), odd);
    for (const Normals normals : {Normals::Auto, Normals::Authored}) {
        const Mesh made = completed(mesh, with(normals));
        EXPECT_EQ(made.positions, mesh.positions);
        EXPECT_EQ(made.normals, mesh.normals);
    }
}

TEST(CompleteNormals, givesFacesTheirOwnWhereTheFilesAreUnwanted) {
    Mesh mesh = fold(20.0);
    mesh.normals.assign(mesh.positions.size(), glm::vec3{0, 1, 0});
    const Mesh made = completed(mesh, with(Normals::Flat));
    for (std::size_t corner = 0; corner < 6; ++corner) expectNear(cornerNormal(made, corner), {0, 0, 1});
    for (std::size_t corner = 6; corner < 12; ++corner) expectNear(cornerNormal(made, corner), rightNormal(20.0));
}

TEST(CompleteNormals, givesFacesTheirOwnWhereAuthoredOnesAreMissing) {
    const Mesh made = completed(fold(20.0), with(Normals::Authored));
    for (std::size_t corner = 0; corner < 6; ++corner) expectNear(cornerNormal(made, corner), {0, 0, 1});
    for (std::size_t corner = 6; corner < 12; ++corner) expectNear(cornerNormal(made, corner), rightNormal(20.0));
}

TEST(CompleteNormals, makesOnlyThoseThatAreZero) {
    Mesh mesh = fold(20.0);
    const glm::vec3 odd = glm::normalize(glm::vec3{0.2F, 0.1F, 1.0F});
    mesh.normals.assign(mesh.positions.size(), odd);
    mesh.normals[4] = mesh.normals[5] = glm::vec3{0.0F};
    const Mesh made = completed(mesh, with(Normals::Auto));
    EXPECT_EQ(cornerNormal(made, 6), odd);
    expectNear(cornerNormal(made, 7), rightNormal(20.0));
    expectNear(cornerNormal(made, 8), rightNormal(20.0));
}

TEST(CompleteNormals, keepsTheOrderOfCorners) {
    const Mesh before = fold(40.0);
    const Mesh made = completed(before, with(Normals::Auto));
    for (std::size_t corner = 0; corner < before.indices.size(); ++corner) {
        EXPECT_EQ(cornerPosition(made, corner), cornerPosition(before, corner));
    }
}

TEST(CompleteNormals, givesAFaceWithoutAreaSomeUnitNormal) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}};
    mesh.indices = {0, 1, 2, 3, 4, 5};
    for (const Normals normals : {Normals::Auto, Normals::Authored, Normals::Flat}) {
        expectUnitNormals(completed(mesh, with(normals)));
    }
}

TEST(CompleteNormals, makesNormalsOfTheSmallestAndTheLargestFaces) {
    for (const float size : {1e-18F, 1e18F}) {
        Mesh mesh = fold(20.0);
        for (glm::vec3& p : mesh.positions) p *= size;
        const Mesh made = completed(mesh, with(Normals::Auto));
        expectNear(cornerNormal(made, 1), rightNormal(10.0));
        expectNear(cornerNormal(made, 0), {0, 0, 1});
    }
}

TEST(CompleteNormals, makesThoseThatAreNotFinite) {
    Mesh mesh = fold(20.0);
    mesh.normals.assign(mesh.positions.size(), glm::vec3{0, 0, 1});
    mesh.normals[4].x = std::numeric_limits<float>::quiet_NaN();
    mesh.normals[5].y = std::numeric_limits<float>::infinity();
    const Mesh made = completed(mesh, with(Normals::Auto));
    expectUnitNormals(made);
    expectNear(cornerNormal(made, 7), rightNormal(20.0));
    expectNear(cornerNormal(made, 8), rightNormal(20.0));
}

}  // namespace
}  // namespace inkedge::mesh
