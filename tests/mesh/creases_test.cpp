#include "mesh/creases.h"

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "mesh/connect.h"
#include "mesh/shapes.h"

namespace inkedge::mesh {
namespace {

constexpr double rounding = 1e-4;  // of lengths: positions are floats

double lengthOfCreases(Mesh mesh, Creases kind = Creases::Auto, double creaseAngle = LoadSettings{}.creaseAngle) {
    LoadSettings settings;
    settings.creases = kind;
    settings.creaseAngle = creaseAngle;
    const MeshTopology topology = connect(mesh, settings);
    double length = 0.0;
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (topology.creases[h] && topology.twins[h] > h)
            length += static_cast<double>(
                glm::distance(mesh.positions[mesh.indices[h]], mesh.positions[mesh.indices[nextHalfEdge(h)]]));
    return length;
}

// Strips between flat normals of their own, or, where an edge is shared, with the mean of the two strips' normals.
Mesh strips(const std::vector<double>& bends, const std::vector<bool>& shared) {
    Mesh mesh = mesh::strips(bends);
    mesh.normals = facetNormals(mesh);
    for (std::size_t i = 0; i < bends.size(); ++i) {
        if (!shared[i]) continue;
        const std::size_t left = 4 * i;
        const std::size_t right = left + 4;
        const glm::vec3 mean = glm::normalize(mesh.normals[left] + mesh.normals[right + 2]);
        mesh.normals[left + 1] = mesh.normals[left + 2] = mean;
        mesh.normals[right] = mesh.normals[right + 3] = mean;
    }
    return mesh;
}

// How many of the edges between strips, which are two long each, are creases.
double edgesBetween(const std::vector<double>& bends, const std::vector<bool>& shared) {
    return lengthOfCreases(strips(bends, shared)) / 2.0;
}

enum class Sides { Plain, Faceted, Smooth };

// The length of creases along the sides of a prism two high; its caps are creases anyway.
double alongSides(int sides, Sides kind, Creases creases = Creases::Auto, double creaseAngle = 34.0) {
    Mesh mesh = prism(sides);
    const double caps = 4.0 * sides * std::sin(std::numbers::pi / sides);
    if (kind != Sides::Plain) mesh.normals = facetNormals(mesh);
    if (kind == Sides::Smooth)
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            if (std::abs(mesh.normals[i].y) < 0.5F)
                mesh.normals[i] = glm::normalize(mesh.positions[i] * glm::vec3{1.0F, 0.0F, 1.0F});
    return lengthOfCreases(mesh, creases, creaseAngle) - caps;
}

TEST(Creases, WithoutNormalsAreBendsOverTheCreaseAngle) {
    EXPECT_NEAR(lengthOfCreases(mesh::strips({36.0, 20.0})), 2.0, rounding);
    EXPECT_NEAR(lengthOfCreases(mesh::strips({36.0, 20.0}), Creases::Auto, 15.0), 4.0, rounding);
    EXPECT_NEAR(alongSides(8, Sides::Plain), 16.0, rounding);
    EXPECT_NEAR(alongSides(24, Sides::Plain), 0.0, rounding);
}

TEST(Creases, AreNotWhereNormalsAreSharedUpToTwiceTheAngle) {
    EXPECT_NEAR(alongSides(8, Sides::Smooth), 0.0, rounding);
    EXPECT_NEAR(alongSides(6, Sides::Smooth), 0.0, rounding);
    EXPECT_NEAR(alongSides(4, Sides::Smooth), 8.0, rounding) << "a cube's 90 degrees";
    EXPECT_EQ(edgesBetween({50.0}, {true}), 0.0);
    EXPECT_NEAR(edgesBetween({80.0}, {true}), 1.0, rounding);
}

TEST(Creases, OfACubeWithAveragedNormalsAreAllTwelveEdges) {
    Mesh mesh;
    for (const float x : {-1.0F, 1.0F})
        for (const float y : {-1.0F, 1.0F})
            for (const float z : {-1.0F, 1.0F}) mesh.positions.emplace_back(x, y, z);
    mesh.indices = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                    2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 5, 7, 1, 7, 3};
    for (const glm::vec3 p : mesh.positions) mesh.normals.push_back(glm::normalize(p));
    EXPECT_NEAR(lengthOfCreases(mesh), 24.0, rounding);
}

TEST(Creases, AreWhereNormalsAreSplitFromTenDegreesOn) {
    for (const double bend : {10.0, 15.0, 20.0, -20.0, 30.0, 50.0})
        EXPECT_NEAR(edgesBetween({bend}, {false}), 1.0, rounding) << bend;
    EXPECT_EQ(edgesBetween({5.0}, {false}), 0.0);
    // Other bends of that size are smooth.
    EXPECT_NEAR(edgesBetween({15.0, 20.0, 15.0, 20.0}, {true, true, true, false}), 1.0, rounding);
    EXPECT_NEAR(edgesBetween({15.0, 20.0, 15.0, 20.0}, {true, false, true, true}), 1.0, rounding);
}

TEST(Creases, AreNotWhereAFewSplitEdgesStandAlone) {
    // A round of 24 smooth sides, cut into rings of faces: one long split line, or a part of it, in one of its sides.
    const auto split = [](std::uint32_t first, std::uint32_t last) {
        constexpr std::uint32_t rings = 8;
        Mesh mesh;
        for (std::uint32_t i = 0; i < 24; ++i) {
            for (std::uint32_t k = 0; k < rings; ++k) {
                const auto base = static_cast<std::uint32_t>(mesh.positions.size());
                const double facet = glm::radians(15.0 * i + 7.5);
                for (const auto& [j, l] : {std::pair{i, k}, {i + 1, k}, {i + 1, k + 1}, {i, k + 1}}) {
                    const double a = glm::radians(15.0 * j);
                    mesh.positions.emplace_back(glm::dvec3{std::cos(a), l, -std::sin(a)});
                    const bool own = j == 24 - 24 * (i == 0) && k >= first && k < last && (i == 0 || i == 23);
                    const double n = own ? facet : a;
                    mesh.normals.emplace_back(glm::dvec3{std::cos(n), 0.0, -std::sin(n)});
                }
                for (const std::uint32_t v : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(base + v);
            }
        }
        return mesh;
    };
    EXPECT_NEAR(lengthOfCreases(split(0, 8)), 8.0, rounding);
    EXPECT_NEAR(lengthOfCreases(split(0, 2)), 2.0, rounding) << "from the border";
    EXPECT_NEAR(lengthOfCreases(split(2, 6)), 4.0, rounding);
    EXPECT_EQ(lengthOfCreases(split(3, 5)), 0.0);
    EXPECT_EQ(lengthOfCreases(split(0, 0)), 0.0);
}

TEST(Creases, OfFacetedRoundsAreBendsOverTheCreaseAngle) {
    EXPECT_NEAR(alongSides(24, Sides::Faceted), 0.0, rounding);
    EXPECT_NEAR(alongSides(16, Sides::Faceted), 0.0, rounding);
    EXPECT_NEAR(alongSides(8, Sides::Faceted), 16.0, rounding);
    EXPECT_EQ(edgesBetween({15.0, 15.0, 15.0, 15.0, 15.0}, {false, false, false, false, false}), 0.0);
    Mesh faceted;
    const Mesh smooth = torus(24, 16);
    for (const std::uint32_t i : smooth.indices) {
        faceted.indices.push_back(static_cast<std::uint32_t>(faceted.positions.size()));
        faceted.positions.push_back(smooth.positions[i]);
    }
    faceted.normals = facetNormals(faceted);
    EXPECT_EQ(lengthOfCreases(faceted), 0.0);
}

TEST(Creases, DoNotListenToNormalsThatDisagreeWithTheBend) {
    Mesh mesh = strips({20.0}, {false});
    const glm::vec3 tilted = glm::normalize(glm::vec3{1.0F, 1.0F, 0.0F});
    for (std::size_t i = 4; i < 8; ++i) mesh.normals[i] = tilted;  // split by 45 degrees, bent by 20
    EXPECT_EQ(lengthOfCreases(mesh), 0.0);
    mesh = strips({40.0}, {true});
    for (std::size_t i = 4; i < 8; ++i)  // split by 6 degrees, bent by 40
        mesh.normals[i] = glm::normalize(mesh.normals[1] + 0.105F * glm::vec3{1.0F, -0.36F, 0.0F});
    EXPECT_NEAR(lengthOfCreases(mesh), 2.0, rounding);
}

TEST(Creases, DoNotListenToRandomNormals) {
    std::mt19937 random{1};  // NOLINT: the same each time
    std::uniform_real_distribution<float> within{-1.0F, 1.0F};
    Mesh mesh = prism(24);
    const double caps = lengthOfCreases(mesh);
    mesh.normals = facetNormals(mesh);
    for (glm::vec3& n : mesh.normals) n = glm::normalize(n + glm::vec3{within(random), within(random), within(random)});
    EXPECT_NEAR(lengthOfCreases(mesh), caps, rounding);
    EXPECT_NEAR(lengthOfCreases(mesh, Creases::Normals), caps, rounding);
}

TEST(Creases, MayBeDecidedByBendsOrByNormalsAlone) {
    const Mesh mesh = strips({20.0, 50.0}, {false, true});
    EXPECT_NEAR(lengthOfCreases(mesh), 2.0, rounding);
    EXPECT_NEAR(lengthOfCreases(mesh, Creases::Angle), 2.0, rounding);
    EXPECT_NEAR(lengthOfCreases(mesh, Creases::Angle, 15.0), 4.0, rounding);
    EXPECT_NEAR(lengthOfCreases(mesh, Creases::Normals, 80.0), 2.0, rounding);
    EXPECT_NEAR(alongSides(8, Sides::Smooth, Creases::Angle), 16.0, rounding);
    EXPECT_NEAR(alongSides(24, Sides::Faceted, Creases::Normals), 48.0, rounding);
}

// A mesh turned, moved and scaled, rounded to a grid of 14 bits, or both.
std::vector<Mesh> posesOf(const Mesh& mesh) {
    std::vector<Mesh> poses{mesh};
    for (const double degrees : {10.0, 33.3, 45.0, 71.0}) {
        const glm::dmat4 turned = glm::rotate(glm::dmat4{1.0}, glm::radians(degrees), glm::dvec3{0.3, 1.0, 0.2});
        const glm::dmat4 moved = glm::translate(glm::scale(glm::dmat4{1.0}, glm::dvec3{0.37}), {0.3, 0.1, -0.2});
        Mesh pose = mesh;
        for (glm::vec3& p : pose.positions) p = moved * turned * glm::dvec4{p, 1.0};
        for (glm::vec3& n : pose.normals) n = turned * glm::dvec4{n, 0.0};
        poses.push_back(pose);
        for (glm::vec3& p : pose.positions) p = glm::round(p * 8192.0F) / 8192.0F;
        poses.push_back(std::move(pose));
    }
    return poses;
}

TEST(Creases, AreTheSameInEveryPoseEvenAtTheCreaseAngle) {
    for (const double creaseAngle : {15.0, 30.0, 34.0, 45.0, 60.0}) {
        for (const int sides : {6, 8, 12, 24}) {
            const double all = 2.0 * sides;
            const bool over = 360.0 / sides > creaseAngle + 1.0;
            for (const Mesh& pose : posesOf(prism(sides))) {
                const double scale = static_cast<double>(glm::distance(pose.positions[1], pose.positions[2])) / 2.0;
                const double caps = 4.0 * sides * std::sin(std::numbers::pi / sides);
                const double sidesLength = lengthOfCreases(pose, Creases::Auto, creaseAngle) / scale - caps;
                EXPECT_NEAR(sidesLength, over ? all : 0.0, 0.01 * all) << sides << " sides, " << creaseAngle;
            }
        }
    }
}

TEST(Creases, InDoubtAreThoseThatCarryOnOthers) {
    // A bend along z, of 40 degrees at one end and of 34.5 further on.
    const auto ridge = [](double first, double second) {
        Mesh mesh;
        const double angles[] = {first, first, second, second};
        for (std::size_t i = 0; i < 4; ++i) {
            const double a = glm::radians(angles[i]);
            const auto z = static_cast<double>(i);
            for (const glm::dvec3& p :
                 {glm::dvec3{-1.0, 0.0, -z}, glm::dvec3{0.0, 0.0, -z}, glm::dvec3{std::cos(a), -std::sin(a), -z}})
                mesh.positions.emplace_back(p);
        }
        for (std::uint32_t i = 0; i < 9; i += 3)
            for (const std::uint32_t k : {0U, 1U, 4U, 0U, 4U, 3U, 1U, 2U, 5U, 1U, 5U, 4U})
                mesh.indices.push_back(i + k);
        return mesh;
    };
    EXPECT_NEAR(lengthOfCreases(ridge(34.5, 34.5)), 0.0, rounding);
    EXPECT_NEAR(lengthOfCreases(ridge(40.0, 34.5)), 3.0, rounding);
    EXPECT_NEAR(lengthOfCreases(ridge(40.0, 20.0)), 2.0, 1.01) << "the strip between twists";
    // Two ridges side by side: none carries on the other.
    EXPECT_NEAR(lengthOfCreases(mesh::strips({40.0, 34.5})), 2.0, rounding);
}

// A rough sheet of square cells, 32 long, with a ridge along x = 0.
// @param bendAt  of the ridge, degrees, by the distance from the middle of its length; the slopes further out stay
Mesh roughRidge(double bend, const std::function<double(int)>& bendAt, double roughness) {
    constexpr int half = 16;
    std::mt19937 random{1};  // NOLINT: the same each time
    std::uniform_real_distribution<double> within{-roughness, roughness};
    const auto slope = [](double degrees) { return std::tan(glm::radians(0.5 * degrees)); };
    Mesh mesh;
    for (int y = -half; y <= half; ++y)
        for (int x = -half; x <= half; ++x) {
            const double fall = x == 0 ? 0.0 : slope(bendAt(std::abs(y))) + slope(bend) * (std::abs(x) - 1);
            mesh.positions.emplace_back(glm::dvec3{x, y, (x == 0 ? 0.0 : within(random)) - fall});
        }
    for (std::uint32_t y = 0; y < 2 * half; ++y)
        for (std::uint32_t x = 0; x < 2 * half; ++x) {
            const std::uint32_t a = y * (2 * half + 1) + x;
            const std::uint32_t b = a + 2 * half + 1;
            for (const std::uint32_t v : {a, a + 1, b + 1, a, b + 1, b}) mesh.indices.push_back(v);
        }
    return mesh;
}

TEST(Creases, OfRoughSurfacesAreCarriedOnAndAreNotShort) {
    constexpr double rough = 0.08;  // half of the edges bend by 4 degrees and more
    const auto even = [](int) { return 50.0; };
    const auto lowInTheMiddle = [](int y) { return y < 6 ? 31.0 : 50.0; };
    const auto highInTheMiddle = [](int y) { return y < 2 ? 44.0 : 10.0; };
    EXPECT_NEAR(lengthOfCreases(roughRidge(50.0, even, rough)), 32.0, rounding);
    EXPECT_NEAR(lengthOfCreases(roughRidge(50.0, lowInTheMiddle, rough)), 32.0, rounding);
    EXPECT_LT(lengthOfCreases(roughRidge(50.0, lowInTheMiddle, rough), Creases::Angle), 25.0);
    EXPECT_LT(lengthOfCreases(roughRidge(50.0, lowInTheMiddle, 0.0)), 25.0) << "not rough: as it is";
    EXPECT_EQ(lengthOfCreases(roughRidge(10.0, highInTheMiddle, rough)), 0.0);
    EXPECT_GT(lengthOfCreases(roughRidge(10.0, highInTheMiddle, rough), Creases::Angle), 1.5);
}

TEST(Creases, ThatEndWithinAPatchSayByHowMuchTheyBend) {
    // A square pyramid of which only one edge is split, and which is smooth all around it.
    Mesh mesh;
    mesh.positions = {{1, 0, 1}, {1, 0, -1}, {-1, 0, -1}, {-1, 0, 1}, {0, 0.4F, 0}};
    mesh.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
    mesh.edges.resize(mesh.indices.size());
    mesh.edges[1] = EdgeKind::Sharp;
    const MeshTopology topology = connect(mesh, {});
    EXPECT_EQ(topology.patchCount(), 1U);
    ASSERT_TRUE(topology.creases[1]);
    EXPECT_NEAR(topology.innerCreaseCosine, bendCosine(buildTopology(mesh), 1, topology.twins[1]), rounding);
    mesh.edges.clear();
    EXPECT_EQ(connect(mesh, {}).innerCreaseCosine, -1.0);
}

}  // namespace
}  // namespace inkedge::mesh
