#include "mesh/subdivide.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <set>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "mesh/closed_surface.h"
#include "mesh/topology.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double smoothAngle = 179.0;  // coarse control meshes bend by more than the usual crease angle

LoadSettings levels(int n, double creaseAngle = 30.0) {
    LoadSettings settings;
    settings.subdivide = n;
    settings.creaseAngle = creaseAngle;
    return settings;
}

Scene refined(const Mesh& mesh, const LoadSettings& settings) {
    return scenes::sceneOf({{mesh, glm::dmat4{1.0}}}, settings);
}

void addQuadsEdges(Mesh& mesh) {
    constexpr EdgeKinds outer;
    constexpr EdgeKinds inner = EdgeKind::Inner;
    mesh.edges.insert(mesh.edges.end(), {outer, outer, inner, inner, outer, outer});
}

void addQuad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    addQuadsEdges(mesh);
}

Mesh asTriangles(Mesh mesh) {
    mesh.edges.clear();
    return mesh;
}

Mesh quadCube() {
    Mesh mesh = scenes::cube();
    for (std::size_t face = 0; face < 6; ++face) addQuadsEdges(mesh);
    return mesh;
}

// Of n x n squares, from -1 to 1 in x and y.
Mesh grid(std::uint32_t n) {
    Mesh mesh;
    for (std::uint32_t y = 0; y <= n; ++y)
        for (std::uint32_t x = 0; x <= n; ++x) mesh.positions.emplace_back(2.0 * x / n - 1.0, 2.0 * y / n - 1.0, 0.0);
    for (std::uint32_t y = 0; y < n; ++y)
        for (std::uint32_t x = 0; x < n; ++x)
            addQuad(mesh, y * (n + 1) + x, y * (n + 1) + x + 1, (y + 1) * (n + 1) + x + 1, (y + 1) * (n + 1) + x);
    return mesh;
}

constexpr double torusRadius = 1.0;
constexpr double tubeRadius = 0.4;

// Vertices on the torus around the z axis, n around it and m around the tube.
Mesh torus(std::uint32_t n, std::uint32_t m) {
    Mesh mesh;
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < m; ++j) {
            const double u = 2.0 * std::numbers::pi * i / n;
            const double v = 2.0 * std::numbers::pi * j / m;
            const double r = torusRadius + tubeRadius * std::cos(v);
            mesh.positions.emplace_back(r * std::cos(u), r * std::sin(u), tubeRadius * std::sin(v));
        }
    }
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < m; ++j)
            addQuad(mesh, i * m + j, (i + 1) % n * m + j, (i + 1) % n * m + (j + 1) % m, i * m + (j + 1) % m);
    return mesh;
}

// Vertices on the unit sphere: an octahedron whose edges are cut into n.
Mesh ball(std::uint32_t n) {
    Mesh mesh;
    for (int side = 0; side < 8; ++side) {
        const glm::dvec3 sign{(side & 1) != 0 ? -1 : 1, (side & 2) != 0 ? -1 : 1, (side & 4) != 0 ? -1 : 1};
        const bool mirrored = sign.x * sign.y * sign.z < 0.0;
        const auto add = [&](std::uint32_t i, std::uint32_t j) {
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
            mesh.positions.emplace_back(sign * glm::normalize(glm::dvec3{i, j, n - i - j}));
        };
        const auto triangle = [&](glm::uvec2 a, glm::uvec2 b, glm::uvec2 c) {
            if (mirrored) std::swap(b, c);
            for (const glm::uvec2 p : {a, b, c}) add(p.x, p.y);
        };
        for (std::uint32_t i = 0; i < n; ++i)
            for (std::uint32_t j = 0; i + j < n; ++j) {
                triangle({i, j}, {i + 1, j}, {i, j + 1});
                if (i + j + 1 < n) triangle({i + 1, j}, {i + 1, j + 1}, {i, j + 1});
            }
    }
    return mesh;
}

glm::dvec3 corner(const Mesh& mesh, std::size_t c) { return glm::dvec3{mesh.positions[mesh.indices[c]]}; }

std::size_t creasesOf(const Scene& scene) {
    return static_cast<std::size_t>(std::ranges::count(topologyOf(scene, 0).creases, true));
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
        EXPECT_EQ(topologyOf(scene, 0).patchCount, 6U);
        EXPECT_TRUE(isClosedOutward(mesh, topologyOf(scene, 0)));
    }
}

TEST(Subdivide, roundsWhatIsNoCrease) {
    for (const Mesh& control : {scenes::cube(), quadCube()}) {
        const Scene scene = refined(control, levels(3, smoothAngle));
        EXPECT_EQ(creasesOf(scene), 0U);
        EXPECT_TRUE(isClosedOutward(scene.meshes()[0], topologyOf(scene, 0)));
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
    const glm::vec3 left = glm::normalize(glm::vec3{-1, 0, 1});
    const glm::vec3 right = glm::normalize(glm::vec3{1, 0, 1});
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
        const std::vector<glm::dvec3> faceNormals = makeFaceNormals(mesh);
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
        EXPECT_EQ(topologyOf(scene, 0).patchCount, 3U);
        EXPECT_EQ(creasesOf(scene), 12U * 8U * 2U);
        EXPECT_TRUE(isClosedOutward(scene.meshes()[0], topologyOf(scene, 0)));
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
        const auto& twins = topologyOf(scene, 0).twins;
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
        for (const glm::vec3 p : scene.meshes()[0].positions) ASSERT_TRUE(std::isfinite(glm::dot(p, p))) << trial;
        ASSERT_LE(scene.box().max.x, 4.0 + 1e-5);  // within the control mesh's hull
        ASSERT_GE(scene.box().min.x, -1e-5);
    }
}

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
// A cube whose faces each are the whole texture, with a vertex for each corner of each triangle.
Mesh texturedCube() {
    const Mesh whole = quadCube();
    Mesh mesh;
    mesh.edges = whole.edges;
    for (std::uint32_t i = 0; i < whole.indices.size(); ++i) {
        mesh.positions.push_back(whole.positions[whole.indices[i]]);
        mesh.indices.push_back(i);
    }
    for (int face = 0; face < 6; ++face)
        mesh.textureCoordinates.insert(mesh.textureCoordinates.end(), {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}});
    return mesh;
}

double textureArea(const Mesh& mesh, std::size_t t) {
    const auto at = [&](std::size_t k) { return glm::dvec2{mesh.textureCoordinates[mesh.indices[3 * t + k]]}; };
    const glm::dvec2 a = at(1) - at(0);
    const glm::dvec2 b = at(2) - at(0);
    return 0.5 * (a.x * b.y - a.y * b.x);
}

TEST(Subdivide, cutsTextureCoordinatesEvenlyAndLeavesSeamsWhereTheyAre) {
    for (const Mesh& cube : {texturedCube(), asTriangles(texturedCube())}) {
        for (const double creaseAngle : {30.0, smoothAngle}) {
            const Scene scene = refined(cube, levels(2, creaseAngle));
            const Mesh& mesh = scene.meshes()[0];
            ASSERT_EQ(mesh.textureCoordinates.size(), mesh.positions.size());
            // Of each face's one, 16 squares of two triangles, or 2 triangles of 16: all of one size, in exact binary.
            for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) EXPECT_EQ(textureArea(mesh, t), 1.0 / 32);
        }
    }
}

// Colours are a function of the position; each face's picture is its own, so that uvs have seams at every edge.
Mesh paintedCube() {
    Mesh mesh = texturedCube();
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec3 share = 0.5F * (mesh.positions[i] + 1.0F);
        mesh.paint.push_back({{share, share.x * share.y * share.z}, 2.0F * mesh.textureCoordinates[i]});
    }
    return mesh;
}

TEST(Subdivide, mixesColoursLinearlyAcrossTheFacesThatWere) {
    for (const Mesh& cube : {paintedCube(), asTriangles(paintedCube())}) {
        const Scene scene = refined(cube, levels(2));  // stays a cube
        const Mesh& mesh = scene.meshes()[0];
        ASSERT_EQ(mesh.paint.size(), mesh.positions.size());
        for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
            const glm::vec3 share = 0.5F * (mesh.positions[i] + 1.0F);
            const glm::vec4 color = mesh.paint[i].color;
            EXPECT_LT(glm::distance(glm::vec3{color}, share), 1e-6F) << i;  // of floats of size 1
            if (cube.edges.empty()) continue;
            EXPECT_NEAR(color.a, share.x * share.y * share.z, 1e-6F) << "bilinear across squares";
        }
    }
}

TEST(Subdivide, mixesColoursAlikeHoweverFacesBend) {
    for (const Mesh& cube : {paintedCube(), asTriangles(paintedCube())}) {
        const Mesh sharp = refined(cube, levels(2)).meshes()[0];
        const Mesh round = refined(cube, levels(2, smoothAngle)).meshes()[0];
        ASSERT_EQ(sharp.indices.size(), round.indices.size());
        ASSERT_EQ(sharp.paint.size(), sharp.positions.size());
        ASSERT_EQ(round.paint.size(), round.positions.size());
        for (std::size_t c = 0; c < sharp.indices.size(); ++c) {
            EXPECT_EQ(sharp.paint[sharp.indices[c]].color, round.paint[round.indices[c]].color);
            EXPECT_EQ(sharp.paint[sharp.indices[c]].uv, round.paint[round.indices[c]].uv);
        }
    }
}

TEST(Subdivide, keepsTheUvsOfPicturesWithTheirSeams) {
    for (Mesh cube : {paintedCube(), asTriangles(paintedCube())}) {
        for (const bool coordinates : {true, false}) {
            if (!coordinates) cube.textureCoordinates.clear();
            const Mesh mesh = refined(cube, levels(2, smoothAngle)).meshes()[0];
            ASSERT_EQ(mesh.paint.size(), mesh.positions.size());
            EXPECT_EQ(mesh.textureCoordinates.size(), coordinates ? mesh.positions.size() : 0U);
            for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
                const auto at = [&](std::size_t k) { return glm::dvec2{mesh.paint[mesh.indices[3 * t + k]].uv}; };
                const glm::dvec2 a = at(1) - at(0);
                const glm::dvec2 b = at(2) - at(0);
                EXPECT_EQ(0.5 * (a.x * b.y - a.y * b.x), 4.0 / 32) << "of each face's 2 x 2, evenly";
            }
        }
    }
}

TEST(Subdivide, givesTheKindsOfEdgesToWhatTheyAreCutInto) {
    for (const Mesh& plain : {quadCube(), asTriangles(quadCube())}) {
        Mesh cube = plain;
        cube.edges.resize(cube.indices.size());
        cube.edges[0] |= EdgeKind::Marked | EdgeKind::Free;  // on one of its faces only
        const glm::dvec3 from{cube.positions[cube.indices[0]]};
        const glm::dvec3 to{cube.positions[cube.indices[1]]};
        const Scene scene = refined(cube, levels(2));
        const Mesh& mesh = scene.meshes()[0];
        ASSERT_EQ(mesh.edges.size(), mesh.indices.size());
        EXPECT_EQ(std::ranges::count(scenes::edgesOfKind(mesh, EdgeKind::Marked), true), 8)
            << "four parts, each on two faces";
        EXPECT_EQ(scenes::edgesOfKind(mesh, EdgeKind::Free), scenes::edgesOfKind(mesh, EdgeKind::Marked));
        for (std::uint32_t h = 0; h < mesh.indices.size(); ++h) {
            if (!mesh.edges[h].has(EdgeKind::Marked)) continue;
            const glm::dvec3 at{mesh.positions[mesh.indices[h]]};
            EXPECT_NEAR(glm::length(glm::cross(at - from, to - from)), 0.0, 1e-6) << "a cube's edges are sharp";
        }
    }
}

TEST(Subdivide, givesTheNumbersOfFacesToWhatTheyAreCutInto) {
    for (const std::size_t perFace : {1U, 2U}) {
        Mesh cube = perFace == 2 ? quadCube() : asTriangles(quadCube());
        for (std::uint32_t t = 0; t < 12; ++t) cube.faces.push_back(100 + t / 2);
        const Mesh mesh = refined(cube, levels(1)).meshes()[0];
        ASSERT_EQ(mesh.faces.size(), mesh.indices.size() / 3);
        for (std::uint32_t face = 100; face < 106; ++face) EXPECT_EQ(std::ranges::count(mesh.faces, face), 8);
        EXPECT_TRUE(std::ranges::is_sorted(mesh.faces));
    }
}

TEST(Subdivide, goesOnAcrossTangentEdges) {
    Mesh cube = quadCube();
    for (EdgeKinds& kinds : cube.edges)
        if (!kinds.has(EdgeKind::Inner)) kinds |= EdgeKind::Tangent;
    const Scene scene = refined(cube, levels(2));
    EXPECT_LT(scene.box().max.x, 1.0) << "rounded, however little the crease angle";
    EXPECT_EQ(std::ranges::count(scenes::edgesOfKind(scene.meshes()[0], EdgeKind::Sharp), true), 0);
}

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

ControlMesh controlOf(const Scene& scene) { return controlMesh(scene.meshes()[0], topologyOf(scene, 0)); }

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
}  // namespace inkedge
