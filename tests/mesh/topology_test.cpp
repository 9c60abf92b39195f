#include "mesh/topology.h"

#include <cmath>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/connect.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

using Corners = std::vector<std::uint32_t>;

constexpr std::uint32_t none = noHalfEdge;

// Triangles between points on a curve of which no three lie on a line and no four in a plane.
Mesh meshOf(const Corners& indices) {
    Mesh mesh;
    std::uint32_t count = 0;
    for (const std::uint32_t i : indices) count = std::max(count, i + 1);
    for (std::uint32_t i = 0; i < count; ++i) {
        const float t = static_cast<float>(i);
        mesh.positions.emplace_back(t, t * t, t * t * t);
    }
    mesh.indices = indices;
    return mesh;
}

Corners twinsOf(const Corners& indices) { return buildTopology(meshOf(indices)).twins; }

TEST(NextHalfEdge, goesRoundItsTriangle) {
    EXPECT_EQ(nextHalfEdge(0), 1U);
    EXPECT_EQ(nextHalfEdge(1), 2U);
    EXPECT_EQ(nextHalfEdge(2), 0U);
    EXPECT_EQ(nextHalfEdge(7), 8U);
    EXPECT_EQ(nextHalfEdge(8), 6U);
}

TEST(BuildTopology, joinsTwoTrianglesAcrossTheirEdge) {
    // 0-1-2 and 2-1-3 share the edge from 1 to 2.
    EXPECT_THAT(twinsOf({0, 1, 2, 2, 1, 3}), ElementsAre(none, 3, none, 1, none, none));
}

TEST(BuildTopology, joinsTrianglesThatAreWoundAgainstEachOther) {
    EXPECT_THAT(twinsOf({0, 1, 2, 1, 2, 3}), ElementsAre(none, 3, none, 1, none, none));
}

TEST(BuildTopology, leavesBordersWithoutTwins) { EXPECT_THAT(twinsOf({0, 1, 2}), Each(none)); }

TEST(BuildTopology, joinsNoneWhereThreeTrianglesMeet) {
    constexpr std::uint32_t many = manyHalfEdges;
    EXPECT_THAT(twinsOf({0, 1, 2, 1, 0, 3, 0, 1, 4}),
                ElementsAre(many, none, none, many, none, none, many, none, none));
    EXPECT_FALSE(isHalfEdge(many));
    EXPECT_FALSE(isHalfEdge(none));
    EXPECT_TRUE(isHalfEdge(0));
}

TEST(BuildTopology, knowsTrianglesThatRepeatAnother) {
    // Whatever their winding and first corner; collapsed ones, too, to a line or to a point.
    const Corners indices{0, 1, 2, 3, 1, 2, 1, 2, 0, 2, 1, 0, 1, 1, 3, 3, 1, 3, 3, 1, 1, 4, 4, 4, 4, 4, 4, 2, 3, 1};
    EXPECT_THAT(buildTopology(meshOf(indices)).originals, ElementsAre(0, 1, 0, 0, 4, 5, 4, 7, 7, 1));
}

TEST(BuildTopology, joinsNoneThatOnlyTouchInAPoint) { EXPECT_THAT(twinsOf({0, 1, 2, 0, 3, 4}), Each(none)); }

TEST(BuildTopology, pairsEveryEdgeOfAClosedMesh) {
    const Corners tetrahedron{0, 1, 2, 0, 2, 3, 0, 3, 1, 3, 2, 1};
    const Corners twins = twinsOf(tetrahedron);
    for (std::uint32_t h = 0; h < twins.size(); ++h) {
        ASSERT_NE(twins[h], none);
        EXPECT_NE(twins[h], h);
        EXPECT_EQ(twins[twins[h]], h);
        EXPECT_EQ(tetrahedron[h], tetrahedron[nextHalfEdge(twins[h])]);
        EXPECT_EQ(tetrahedron[nextHalfEdge(h)], tetrahedron[twins[h]]);
    }
}

TEST(BuildTopology, takesManyEdgesAtOnePoint) {
    // A closed fan around point 0.
    constexpr std::uint32_t spokes = 1000;
    Corners fan;
    for (std::uint32_t i = 0; i < spokes; ++i) fan.insert(fan.end(), {0, 1 + i, 1 + (i + 1) % spokes});
    Mesh mesh = meshOf(fan);
    for (std::uint32_t i = 0; i < spokes; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / spokes;
        mesh.positions[1 + i] = glm::vec3{glm::dvec3{std::cos(angle), std::sin(angle), 0.0}};
    }
    const Corners twins = buildTopology(mesh).twins;
    for (std::uint32_t i = 0; i < spokes; ++i) {
        EXPECT_EQ(twins[3 * i + 2], 3 * ((i + 1) % spokes));
        EXPECT_EQ(twins[3 * i + 1], none);
    }
}

TEST(BuildTopology, joinsAcrossVerticesAtOnePosition) {
    Mesh mesh = meshOf({0, 1, 2, 3, 4, 5});
    mesh.positions[3] = mesh.positions[2];
    mesh.positions[4] = mesh.positions[1];
    const MeshTopology topology = buildTopology(mesh);
    EXPECT_THAT(topology.points, ElementsAre(0, 1, 2, 2, 1, 3));
    EXPECT_EQ(topology.pointCount, 4U);
    EXPECT_THAT(topology.twins, ElementsAre(none, 3, none, 1, none, none));
}

TEST(BuildTopology, letsRepeatedTrianglesTakeNoPart) {
    // The second repeats the first, the third does so the other way round; the last is a neighbour.
    const Corners twins = twinsOf({0, 1, 2, 1, 2, 0, 0, 2, 1, 2, 1, 3});
    EXPECT_THAT(twins, ElementsAre(none, 9, none, none, none, none, none, none, none, 1, none, none));
}

TEST(BuildTopology, letsCollapsedTrianglesTakeNoPart) {
    EXPECT_THAT(twinsOf({0, 1, 1, 0, 1, 2, 1, 0, 3}), ElementsAre(none, none, none, 6, none, none, 3, none, none));
}

TEST(BuildTopology, givesFacesTheirUnitNormalsByWinding) {
    const MeshTopology topology = buildTopology(scenes::quad({0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}));
    EXPECT_THAT(topology.faceNormals, Each(glm::dvec3(0, 0, 1)));
    Mesh line = meshOf({0, 1, 2});
    line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
    EXPECT_THAT(buildTopology(line).faceNormals, Each(glm::dvec3(0.0)));
}

// A flat sheet of four triangles. The second one is slim; a corner of it lies past the opposite side, by a depth.
Mesh sheetWithFold(double depth) {
    Mesh mesh;
    for (const glm::dvec3 p : {glm::dvec3{0, 0, 0}, {1, 0, 0}, {0.5, -depth, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}})
        mesh.positions.emplace_back(p);
    mesh.indices = {0, 3, 1, 0, 1, 2, 0, 2, 4, 2, 1, 4};
    return mesh;
}

TEST(BuildTopology, givesNoNormalToAFoldOfRounding) {
    const glm::dvec3 up{0, 0, 1};
    EXPECT_THAT(buildTopology(sheetWithFold(-1e-3)).faceNormals, ElementsAre(up, up, up, up));
    EXPECT_THAT(buildTopology(sheetWithFold(1e-4)).faceNormals, ElementsAre(up, glm::dvec3{0.0}, up, up));
    EXPECT_THAT(buildTopology(sheetWithFold(1e-3)).faceNormals, ElementsAre(up, -up, up, up)) << "it can be seen";
    Mesh mesh = sheetWithFold(1e-4);
    EXPECT_THAT(makeFaceNormals(mesh, buildTopology(mesh)), ElementsAre(up, glm::dvec3{0.0}, up, up));
    EXPECT_THAT(normalsOfTriangles(mesh), ElementsAre(up, -up, up, up));
    std::swap(mesh.indices[1], mesh.indices[2]);  // the first face is wound the other way
    EXPECT_THAT(buildTopology(mesh).faceNormals, ElementsAre(-up, glm::dvec3{0.0}, up, up));
}

TEST(BuildTopology, ofNothingIsNothing) {
    const MeshTopology topology = buildTopology(Mesh{});
    EXPECT_THAT(topology.twins, IsEmpty());
    EXPECT_EQ(topology.pointCount, 0U);
}

// Two unit squares that share the edge x = 0 and bend by an angle about it.
Mesh fold(double degrees) {
    const double a = glm::radians(degrees);
    const glm::dvec3 right{std::cos(a), 0, -std::sin(a)};
    Mesh mesh;
    for (const glm::dvec3& p : {glm::dvec3{-1, 0, 0}, glm::dvec3{0}, glm::dvec3{0, 1, 0}, glm::dvec3{-1, 1, 0}, right,
                                right + glm::dvec3{0, 1, 0}}) {
        mesh.positions.emplace_back(p);
    }
    mesh.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    return mesh;
}

TEST(BendCosine, isThatOfTheAngleBetweenTheFaces) {
    for (const double degrees : {-120.0, 0.0, 40.0, 170.0}) {
        Mesh mesh = fold(degrees);
        const MeshTopology topology = buildTopology(mesh);
        ASSERT_EQ(topology.twins[1], 11U);
        // Float positions give the faces within 1e-7.
        EXPECT_NEAR(bendCosine(topology, 1, 11), std::cos(glm::radians(degrees)), 1e-6);
        std::swap(mesh.indices[9], mesh.indices[10]);  // winds the neighbour the other way round
        const MeshTopology against = buildTopology(mesh);
        EXPECT_NEAR(bendCosine(against, 1, against.twins[1]), std::cos(glm::radians(degrees)), 1e-6);
    }
}

// Of each triangle the number of its surface: the first of its patches.
Corners surfacesOf(Mesh mesh, double creaseAngle) {
    LoadSettings settings;
    settings.creaseAngle = creaseAngle;
    const MeshTopology topology = connect(mesh, settings);
    EXPECT_EQ(topology.patchCount(), *std::ranges::max_element(topology.patches) + 1);
    Corners surfaces;
    for (std::uint32_t t = 0; t < topology.patches.size(); ++t) surfaces.push_back(topology.surfaceOf(t));
    return surfaces;
}

TEST(BuildPatches, endAtBendsOverTheCreaseAngle) {
    EXPECT_THAT(surfacesOf(fold(40.0), 39.01), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(surfacesOf(fold(40.0), 38.99), ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(surfacesOf(fold(-40.0), 38.99), ElementsAre(0, 0, 1, 1));
}

TEST(BuildPatches, goOnAcrossTheInnerEdgesOfAPolygon) {
    Mesh mesh = fold(40.0);  // the fold is the edge from corner 1 to 2 of triangle 0, and triangle 2's own
    const MeshTopology topology = buildTopology(mesh);
    const auto bend = static_cast<std::uint32_t>(
        std::ranges::find_if(topology.twins, [&](std::uint32_t h) { return isHalfEdge(h) && h / 3 >= 2; }) -
        topology.twins.begin());
    mesh.edges.resize(mesh.indices.size());
    mesh.edges[bend] = EdgeKind::Inner;
    EXPECT_THAT(surfacesOf(mesh, 30.0), ElementsAre(0, 0, 1, 1)) << "both triangles must say so";
    mesh.edges[topology.twins[bend]] = EdgeKind::Inner;
    EXPECT_THAT(surfacesOf(mesh, 30.0), ElementsAre(0, 0, 0, 0));

    // Turned over, a triangle takes its inner edges along.
    for (std::size_t t = 0; t < 12; t += 3) turnOver(mesh, t);
    EXPECT_THAT(surfacesOf(mesh, 30.0), ElementsAre(0, 0, 0, 0));
    mesh.edges.assign(mesh.indices.size(), {});
    EXPECT_THAT(surfacesOf(mesh, 30.0), ElementsAre(0, 0, 1, 1));
}

TEST(BuildPatches, areDecidedByTheKindOfAnEdgeBeforeItsAngle) {
    const auto patches = [](double bend, EdgeKinds kinds) {
        Mesh mesh = fold(bend);
        const MeshTopology topology = buildTopology(mesh);
        mesh.edges.resize(mesh.indices.size());
        for (std::uint32_t h = 0; h < 6; ++h)
            if (isHalfEdge(topology.twins[h]) && topology.twins[h] / 3 >= 2) mesh.edges[h] = kinds;
        return surfacesOf(mesh, 30.0);
    };
    EXPECT_THAT(patches(5.0, {}), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(patches(5.0, EdgeKind::Sharp), ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(patches(40.0, {}), ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(patches(40.0, EdgeKind::Tangent), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(patches(40.0, EdgeKind::Seam), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(patches(40.0, EdgeKind::Tangent | EdgeKind::Sharp), ElementsAre(0, 0, 0, 0));
    EXPECT_THAT(patches(40.0, EdgeKind::Marked | EdgeKind::Free), ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(patches(5.0, EdgeKind::Marked | EdgeKind::Free), ElementsAre(0, 0, 0, 0));
}

TEST(BuildPatches, partASurfaceWhereItBendsByMoreThanTheCreaseAngle) {
    Mesh mesh = fold(40.0);
    const MeshTopology sharp = connect(mesh, {});
    EXPECT_THAT(sharp.patches, ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(sharp.surfaces, ElementsAre(0, 1));
    mesh = fold(40.0);
    mesh.edges.assign(mesh.indices.size(), EdgeKind::Tangent);
    const MeshTopology smooth = connect(mesh, {});
    EXPECT_THAT(smooth.patches, ElementsAre(0, 0, 1, 1));
    EXPECT_THAT(smooth.surfaces, ElementsAre(0, 0));
}

TEST(BuildPatches, areACubesSixFacesAndAWholeSphere) {
    EXPECT_THAT(surfacesOf(scenes::cube(), 30.0), ElementsAre(0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5));
    EXPECT_THAT(surfacesOf(scenes::sphere(), 30.0), Each(0));
}

TEST(BuildPatches, hangTogetherWhicheverWayTheirFacesAreWound) {
    Mesh mesh = fold(10.0);
    for (std::size_t t = 6; t < 12; t += 3) std::swap(mesh.indices[t + 1], mesh.indices[t + 2]);
    EXPECT_THAT(surfacesOf(mesh, 30.0), Each(0));
}

TEST(BuildPatches, hangTogetherAcrossAFaceWithoutArea) {
    // The left side's edge is split by a vertex that the right side's is not; a face without area closes the gap.
    Mesh mesh;
    mesh.positions = {{-1, 0, 0}, {0, 0, 0}, {0, 2, 0}, {0, 1, 0}, {1, 0, 0}};
    mesh.indices = {0, 1, 3, 0, 3, 2, 1, 2, 3, 1, 4, 2};
    EXPECT_THAT(surfacesOf(mesh, 30.0), Each(0));
}

TEST(BuildTopology, givesNoNormalToFacesThinnerThanRounding) {
    // The box of these corners has a diagonal of 1: the weld tolerance is 5e-7, the minimum height 2e-6.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0.5F, 1.5e-6F, 0}, {0.5F, 2.5e-6F, 0}};
    mesh.indices = {0, 1, 2, 0, 1, 3};
    EXPECT_THAT(buildTopology(mesh).faceNormals, ElementsAre(glm::dvec3(0.0), glm::dvec3(0, 0, 1)));
}

TEST(BuildPatches, countRepeatedTrianglesToTheFirst) {
    Mesh mesh = fold(90.0);
    mesh.indices.insert(mesh.indices.end(), {5, 4, 1});
    EXPECT_THAT(surfacesOf(mesh, 30.0), ElementsAre(0, 0, 1, 1, 1));
}

}  // namespace
}  // namespace inkedge::mesh
