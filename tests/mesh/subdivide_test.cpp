#include "mesh/subdivide.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "mesh/closed_surface.h"
#include "mesh/control_meshes.h"
#include "mesh/topology.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

using namespace control_meshes;
using testing::Each;
using testing::HasSubstr;

std::size_t creasesOf(const Scene& scene) {
    return static_cast<std::size_t>(std::ranges::count(scene::topologyOf(scene, 0).creases, true));
}

TEST(Subdivide, leavesACubeWithCreasesACube) {
    for (const Mesh& control : {scenes::cube(), quadCube()}) {
        const Scene scene = refined(control, levels(3));
        const Mesh& mesh = scene.meshes()[0];
        EXPECT_EQ(mesh.indices.size(), 12U * 64U * 3U);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 p = mesh.positions[i];
            const glm::vec3 n = mesh.normals[i];
            // On the face of its normal, which is an axis.
            EXPECT_NEAR(glm::dot(p, n), 1.0F, 1e-6F);
            EXPECT_NEAR(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1.0F, 1e-6F);
        }
        EXPECT_EQ(creasesOf(scene), 12U * 8U * 2U);
        EXPECT_EQ(scene::topologyOf(scene, 0).patchCount(), 6U);
        EXPECT_TRUE(isClosedOutward(mesh, scene::topologyOf(scene, 0)));
    }
}

TEST(Subdivide, roundsWhatIsNoCrease) {
    for (const Mesh& control : {scenes::cube(), quadCube()}) {
        const Scene scene = refined(control, levels(3, smoothAngle));
        EXPECT_EQ(creasesOf(scene), 0U);
        EXPECT_TRUE(isClosedOutward(scene.meshes()[0], scene::topologyOf(scene, 0)));
        // The surface lies within its control mesh and leaves its corners.
        EXPECT_LT(scene.bounds().radius, 1.6);
        EXPECT_LT(scene.box().max.x, 1.0);
    }
}

TEST(Subdivide, putsTheQuadsOfTheFileTogetherAgain) {
    const auto innerEdges = [](const Scene& scene) {
        return std::ranges::count(scenes::edgesOfKind(scene.meshes()[0], EdgeKind::Inner), true);
    };
    // Catmull-Clark makes four quads of one, each cut once.
    const Scene quads = refined(quadCube(), levels(2, smoothAngle));
    EXPECT_EQ(quads.triangleCount(), 6U * 16U * 2U);
    EXPECT_EQ(innerEdges(quads), 6 * 16 * 2);
    // A limit point of Catmull-Clark at a vertex of three quads: (n^2 v + 4 sum e + sum f) / (n (n + 5)).
    const glm::dvec3 expected = (9.0 * glm::dvec3{1} + 4.0 * glm::dvec3{1} + glm::dvec3{-1}) / 24.0;
    double nearest = 1.0;
    for (const glm::vec3 p : quads.meshes()[0].positions)
        nearest = std::min(nearest, glm::distance(glm::dvec3{p}, expected));
    EXPECT_LT(nearest, 1e-6);
    EXPECT_EQ(innerEdges(refined(asTriangles(quadCube()), levels(2, smoothAngle))), 0);
}

TEST(Subdivide, takesPolygonsOfAnyNumberOfCorners) {
    Mesh pentagon;
    for (int i = 0; i < 5; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 5.0;
        pentagon.positions.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    pentagon.indices = {0, 1, 2, 0, 2, 3, 0, 3, 4};
    constexpr EdgeKinds outer;
    constexpr EdgeKinds inner = EdgeKind::Inner;
    pentagon.edges = {outer, outer, inner, inner, outer, inner, inner, outer, outer};
    EXPECT_EQ(refined(pentagon, levels(1)).triangleCount(), 10U);
    EXPECT_EQ(refined(pentagon, levels(3)).triangleCount(), 160U);
    // What is no polygon: an inner edge around a vertex, all around.
    Mesh fan = scenes::cube();
    fan.edges.assign(fan.indices.size(), EdgeKind::Inner);
    EXPECT_EQ(refined(fan, levels(1)).triangleCount(), 12U * 3U * 2U);
}

TEST(Subdivide, keepsAGridsBorderAndCorners) {
    for (const Mesh& control : {grid(3), asTriangles(grid(3))}) {
        const Scene scene = refined(control, levels(3));
        const Mesh& mesh = scene.meshes()[0];
        EXPECT_THAT(mesh.normals, Each(glm::vec3(0.0F, 0.0F, 1.0F)));
        EXPECT_EQ(scene.box().min, glm::dvec3(-1.0, -1.0, 0.0));
        EXPECT_EQ(scene.box().max, glm::dvec3(1.0, 1.0, 0.0));
        double area = 0.0;
        for (std::size_t c = 0; c < mesh.indices.size(); c += 3)
            area += 0.5 * glm::cross(corner(mesh, c + 1) - corner(mesh, c), corner(mesh, c + 2) - corner(mesh, c)).z;
        EXPECT_NEAR(area, 4.0, 1e-5);  // whole: no corner cut off, nothing folded; positions are floats
    }
}

TEST(Subdivide, keepsCreasesThatOnlyNormalsMake) {
    // Two faces that bend by less than the crease angle, whose normals the file splits.
    Mesh roof;
    const float rise = 0.1F;
    roof.positions = {{-1, 0, 0},   {0, 0, rise}, {0, 1, rise}, {-1, 1, 0},
                      {0, 0, rise}, {1, 0, 0},    {1, 1, 0},    {0, 1, rise}};
    const glm::vec3 left = glm::normalize(glm::vec3{-rise, 0, 1});
    const glm::vec3 right = glm::normalize(glm::vec3{rise, 0, 1});
    roof.normals = {left, left, left, left, right, right, right, right};
    roof.indices = {0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    EXPECT_EQ(creasesOf(refined(roof, levels(0))), 2U);
    const Scene scene = refined(roof, levels(3));
    EXPECT_EQ(creasesOf(scene), 16U);
    for (std::size_t i = 0; i < scene.meshes()[0].positions.size(); ++i)  // its two planes stay as they are
        EXPECT_NEAR(std::abs(scene.meshes()[0].normals[i].x), rise / std::hypot(1.0F, rise), 1e-5F);
    for (glm::vec3& n : roof.normals) n = glm::vec3{0, 0, 1};
    EXPECT_EQ(creasesOf(refined(roof, levels(3))), 0U);
}

TEST(Subdivide, keepsMaterialsAndOrder) {
    Mesh mesh = asTriangles(grid(2));
    mesh.name = "sheet";
    mesh.origin = {100.0, 0.0, 0.0};
    for (std::uint32_t t = 0; t < 8; ++t) mesh.materials.push_back(t);
    const Scene scene = scenes::sceneOf({{mesh, glm::dmat4{1.0}}, {scenes::cube(), glm::dmat4{2.0}}}, levels(2));
    ASSERT_EQ(scene.meshes().size(), 2U);
    EXPECT_EQ(scene.meshes()[0].name, "sheet");
    EXPECT_EQ(scene.meshes()[0].origin, glm::dvec3(100.0, 0.0, 0.0));
    EXPECT_EQ(scene.instances()[1].mesh, 1U);
    const auto& materials = scene.meshes()[0].materials;
    ASSERT_EQ(materials.size(), 8U * 16U);
    for (std::size_t t = 0; t < materials.size(); ++t) EXPECT_EQ(materials[t], t / 16);
}

TEST(Subdivide, givesTheNormalsOfTheLimitSurface) {
    for (const Mesh& control : {torus(10, 8), asTriangles(torus(10, 8))}) {
        // Vertices of one level are vertices of the next, at the same position with the same normal.
        const Scene coarse = refined(control, levels(1, smoothAngle));
        const Scene fine = refined(control, levels(3, smoothAngle));
        const Mesh& mesh = fine.meshes()[0];
        for (std::size_t i = 0; i < coarse.meshes()[0].positions.size(); ++i) {
            const glm::vec3 p = coarse.meshes()[0].positions[i];
            const auto same =
                std::ranges::min_element(mesh.positions, {}, [&](glm::vec3 q) { return glm::distance(p, q); });
            ASSERT_LT(glm::distance(*same, p), 1e-6F);
            const glm::vec3 normal = mesh.normals[static_cast<std::size_t>(same - mesh.positions.begin())];
            EXPECT_LT(glm::distance(normal, coarse.meshes()[0].normals[i]), 1e-5F);
        }
        // And they are at right angles to the faces around, as far as those are small: they bend by 0.03 at most.
        const std::vector<glm::dvec3> faceNormals = normalsOfTriangles(mesh);
        for (std::size_t c = 0; c < mesh.indices.size(); ++c)
            EXPECT_GT(glm::dot(glm::dvec3{mesh.normals[mesh.indices[c]]}, faceNormals[c / 3]), 0.995);
    }
}

// Of six sides, along the z axis: its rims are creases at 65 degrees, its sides are smooth.
Mesh barrel(double bulge) {
    Mesh mesh;
    for (int i = 0; i < 6; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 6.0;
        for (const double z : {-1.0, 0.0, 1.0}) {
            const double r = z == 0.0 ? 1.0 + bulge : 1.0;
            mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
        }
    }
    for (std::uint32_t i = 0; i < 6; ++i) {
        const std::uint32_t next = (i + 1) % 6;
        for (const std::uint32_t ring : {0U, 1U})
            addQuad(mesh, 3 * i + ring, 3 * next + ring, 3 * next + ring + 1, 3 * i + ring + 1);
        if (i < 1 || i > 4) continue;
        mesh.indices.insert(mesh.indices.end(), {0, 3 * next, 3 * i, 2, 3 * i + 2, 3 * next + 2});
        mesh.edges.resize(mesh.indices.size());
    }
    return mesh;
}

TEST(Subdivide, keepsNormalsOfAllLevelsAtCreases) {
    for (const Mesh& control : {barrel(0.4), asTriangles(barrel(0.4))}) {
        const Mesh coarse = refined(control, levels(2, 65.0)).meshes()[0];
        const Mesh fine = refined(control, levels(4, 65.0)).meshes()[0];
        for (std::size_t i = 0; i < coarse.positions.size(); ++i) {
            float nearest = 2.0F;
            for (std::size_t j = 0; j < fine.positions.size(); ++j) {
                if (glm::distance(coarse.positions[i], fine.positions[j]) > 1e-6F) continue;
                nearest = std::min(nearest, glm::distance(coarse.normals[i], fine.normals[j]));
            }
            EXPECT_LT(nearest, 1e-5F) << i;
        }
    }
}

TEST(Subdivide, givesEachSideOfACurvedCreaseItsNormals) {
    // Along the axis or across it.
    for (const Mesh& control : {barrel(0.0), asTriangles(barrel(0.0))}) {
        const Scene scene = refined(control, levels(3, 65.0));
        EXPECT_EQ(scene::topologyOf(scene, 0).patchCount(), 3U);
        EXPECT_EQ(creasesOf(scene), 12U * 8U * 2U);
        EXPECT_TRUE(isClosedOutward(scene.meshes()[0], scene::topologyOf(scene, 0)));
        for (const glm::vec3 n : scene.meshes()[0].normals)
            EXPECT_TRUE(std::abs(n.z) < 1e-5F || std::abs(n.z) > 1.0F - 1e-5F) << n.z;
    }
}

TEST(Subdivide, refusesWhatIsOverTheLimitBeforeItIsMade) {
    LoadSettings settings = levels(6);
    settings.limits.vertices = 100'000;
    try {
        static_cast<void>(refined(torus(100, 100), settings));
        FAIL() << "not refused";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        EXPECT_THAT(error.what(),
                    HasSubstr("expected at most 100000 vertices and indices once subdivided 6 times, found 2.87e+08"));
    }
    // As many as there are: 4 x 16 + 2 vertices of a cube, and 6 x 16 x 6 indices.
    settings = levels(2, smoothAngle);
    settings.limits.vertices = 98 + 576;
    EXPECT_EQ(refined(quadCube(), settings).meshes()[0].positions.size(), 98U);
    settings.limits.vertices -= 1;
    EXPECT_THROW(static_cast<void>(refined(quadCube(), settings)), Error);
}

TEST(Subdivide, holdsTwoCubesTogetherThatShareAnEdge) {
    Mesh both = scenes::cube();
    const Mesh one = both;
    for (const glm::vec3 p : one.positions) both.positions.push_back(p + glm::vec3{2, 2, 0});
    for (const std::uint32_t i : one.indices) both.indices.push_back(i + 8);
    const Scene scene = refined(both, levels(2));
    for (const glm::vec3 p : scene.meshes()[0].positions) {
        const glm::vec3 near = p.x > 1.0F || p.y > 1.0F ? p - glm::vec3{2, 2, 0} : p;
        EXPECT_NEAR(std::max({std::abs(near.x), std::abs(near.y), std::abs(near.z)}), 1.0F, 1e-6F);
    }
    EXPECT_EQ(scene.triangleCount(), 24U * 16U);
}

TEST(Subdivide, opensNoGapWhereManyFacesMeet) {
    // Three leaves of a book, each bent otherwise: at their shared spine they stay together.
    Mesh book;
    for (int i = 0; i < 4; ++i)
        book.positions.emplace_back(0.1F * static_cast<float>(i * i), 0.0F, static_cast<float>(i));
    for (int leaf = 0; leaf < 3; ++leaf) {
        const double angle = 2.0 * leaf;
        const auto first = static_cast<std::uint32_t>(book.positions.size());
        for (int i = 0; i < 4; ++i) book.positions.emplace_back(std::cos(angle), std::sin(angle), i + 0.3 * leaf);
        for (std::uint32_t i = 0; i < 3; ++i) addQuad(book, i, i + 1, first + i + 1, first + i);
    }
    for (const Mesh& control : {book, asTriangles(book)}) {
        const Scene scene = refined(control, levels(2, smoothAngle));
        const auto& twins = scene::topologyOf(scene, 0).twins;
        EXPECT_EQ(std::ranges::count(twins, manyHalfEdges), 3 * 3 * 4);  // leaves, edges of the spine, their parts
    }
}

TEST(Subdivide, takesFacesThatNoSurfaceHas) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {5, 5, 5}, {6, 5, 5}, {5, 6, 5}};
    mesh.indices = {0, 1, 2, 0, 1, 3, 1, 0, 4, 0, 1, 4,   // many at one edge, one of them twice
                    2, 1, 0, 0, 0, 1, 1, 1, 1,            // one turned over, two collapsed
                    5, 6, 7, 1, 2, 4, 2, 1, 3, 3, 2, 4};  // one alone, and some wound anyhow
    const Scene scene = refined(mesh, levels(2));
    EXPECT_EQ(scene.triangleCount(), 7U * 16U);

    Mesh collapsed;
    collapsed.positions = {{0, 0, 0}, {1, 0, 0}};
    collapsed.indices = {0, 1, 1};
    EXPECT_EQ(refined(collapsed, levels(2)).triangleCount(), 1U);
}

TEST(Subdivide, survivesAnyFacesBetweenAFewPoints) {
    std::mt19937 random{7};
    for (int trial = 0; trial < 300; ++trial) {
        Mesh mesh;
        for (int i = 0; i < 7; ++i) {
            const auto coordinate = [&] { return static_cast<float>(random() % 5); };
            mesh.positions.emplace_back(coordinate(), coordinate(), coordinate());
        }
        for (int i = 0; i < 3 * 16; ++i) mesh.indices.push_back(static_cast<std::uint32_t>(random() % 7));
        if (trial % 2 == 0)
            for (int i = 0; i < 3 * 16; ++i) mesh.edges.push_back(random() % 2 == 0 ? EdgeKind::Inner : EdgeKinds{});
        const Scene scene = refined(mesh, levels(2, trial % 3 == 0 ? smoothAngle : 30.0));
        for (const glm::vec3 n : scene.meshes()[0].normals) ASSERT_NEAR(glm::length(n), 1.0F, 1e-4F) << trial;
        const Mesh& made = scene.meshes()[0];
        for (std::uint32_t c = 0; made.surfaces && c < made.indices.size(); ++c) {
            const auto part = made.surfaces->under(made, c / 3);
            const glm::dvec3 p = made.surfaces->at(part->face, part->corners[c % 3]).position;
            ASSERT_TRUE(std::isfinite(glm::length(p))) << trial;
        }
        for (const glm::vec3 p : scene.meshes()[0].positions) ASSERT_TRUE(std::isfinite(glm::dot(p, p))) << trial;
        ASSERT_LE(scene.box().max.x, 4.0 + 1e-5);  // within the control mesh's hull
        ASSERT_GE(scene.box().min.x, -1e-5);
    }
}

}  // namespace
}  // namespace inkedge::mesh
