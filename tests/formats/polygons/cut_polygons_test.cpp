#include "formats/polygons/polygons.h"

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "formats/polygons/load_polygons.h"
#include "formats/polygons/polygon_files.h"

namespace inkedge::polygons {
namespace {

using namespace polygon_files;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

// ---- polygons

TEST_F(LoadPolygons, marksTheEdgesThatOnlyCutPolygons) {
    const Mesh square = obj("v 0 0 0\nv 1 0 0\nv 1 1 0.7\nv 0 1 0\nf 1 2 3 4\n").meshes.at(0);
    ASSERT_THAT(square.indices, SizeIs(6));
    int inner = 0;
    for (std::size_t i = 0; i < 6; ++i) {
        const glm::vec3 a = square.positions[square.indices[i]];
        const glm::vec3 b = square.positions[square.indices[i / 3 * 3 + (i + 1) % 3]];
        EXPECT_EQ(square.edges.at(i).has(EdgeKind::Inner), a.x != b.x && a.y != b.y) << i;
        inner += square.edges.at(i).has(EdgeKind::Inner) ? 1 : 0;
    }
    EXPECT_EQ(inner, 2);
    EXPECT_THAT(obj(triangleObj).meshes.at(0).edges, IsEmpty());
    // The second polygon is a triangle: all its edges are the file's.
    const Mesh mixed = obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n").meshes.at(0);
    EXPECT_EQ(std::ranges::count(mixed.edges, EdgeKinds{EdgeKind::Inner}), 2);
    EXPECT_THAT(mixed.edges, SizeIs(9));
}

TEST_F(LoadPolygons, cutsConcavePolygonsWithinTheirOutline) {
    for (int turn = 0; turn < 8; ++turn) {
        std::string face = "f";
        for (int i = 0; i < 8; ++i) face += fmt::format(" {}", (i + turn) % 8 + 1);
        const Scene::Data data = obj(letterL + face + "\n");
        EXPECT_THAT(data.meshes.at(0).indices, SizeIs(18)) << face;
        EXPECT_EQ(area(data), glm::dvec3(0, 0, 3)) << face;
        EXPECT_EQ(unsignedArea(data), 3.0) << face;
    }
    const Scene::Data dart = obj("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\nf 1 2 3 4\n");
    EXPECT_EQ(unsignedArea(dart), 1.0);
}

TEST_F(LoadPolygons, cutsPolygonsInEveryPlaneAndDirection) {
    const std::vector<std::vector<double>> polygon{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {3, 1}, {1, 1}, {1, 4}, {0, 4}};
    for (int axis = 0; axis < 3; ++axis) {
        for (const bool backwards : {false, true}) {
            std::string content;
            std::string face = "f";
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                std::vector<double> point{7, 7, 7};
                point[static_cast<std::size_t>(axis + 1) % 3] = polygon[i][0];
                point[static_cast<std::size_t>(axis + 2) % 3] = polygon[i][1];
                content += fmt::format("v {}\n", fmt::join(point, " "));
                face += fmt::format(" {}", backwards ? polygon.size() - i : i + 1);
            }
            glm::dvec3 expected{0.0};
            expected[axis] = backwards ? -10.0 : 10.0;
            EXPECT_EQ(area(obj(content + face + "\n")), expected);
            EXPECT_EQ(unsignedArea(obj(content + face + "\n")), 10.0);
        }
    }
}

TEST_F(LoadPolygons, usesEveryCornerOfAPolygonSoThatNeighboursMeetIt) {
    const Scene::Data data = obj("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 3 1 0\nv 0 1 0\nf 1 2 3 4 5 6\n");
    std::vector<int> uses(6);
    for (const std::uint32_t index : data.meshes.at(0).indices) ++uses.at(index);
    EXPECT_THAT(uses, Each(testing::Ge(1)));
    EXPECT_THAT(data.meshes[0].indices, SizeIs(12));
    EXPECT_EQ(unsignedArea(data), 3.0);
}

TEST_F(LoadPolygons, cutsConvexQuadsFromTheirFirstCorner) {
    const Scene::Data data = obj("v 0 0 0\nv 4 0 1\nv 4 4 0\nv 0 4 1\nf 1 2 3 4\n");
    EXPECT_THAT(data.meshes.at(0).indices, ElementsAre(0, 1, 2, 0, 2, 3));
}

TEST_F(LoadPolygons, cutsConcaveQuadsFromTheirHollowCorner) {
    const Scene::Data data = obj("v 0 0 0\nv 1 1 0\nv 4 0 0\nv 0 4 0\nf 1 2 3 4\n");
    EXPECT_THAT(data.meshes.at(0).indices, ElementsAre(1, 2, 3, 1, 3, 0));
}

TEST(PolygonCutter, cutsWhateverItGetsIntoTwoTrianglesLessThanCorners) {
    PolygonCutter cutter;
    std::srand(7);
    const auto random = [] { return static_cast<double>(std::rand() % 9); };
    for (int round = 0; round < 2000; ++round) {
        std::vector<glm::dvec3> polygon(static_cast<std::size_t>(3 + std::rand() % 20));
        for (glm::dvec3& corner : polygon) corner = {random(), random(), round % 3 == 0 ? 0.0 : random()};
        const auto triangles = cutter.cut(polygon);
        ASSERT_EQ(triangles.size(), polygon.size() - 2);
        glm::dvec3 sum{0.0};
        glm::dvec3 expected{0.0};
        for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
            expected += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
        for (const auto& [a, b, c] : triangles) {
            ASSERT_LT(std::max({a, b, c}), polygon.size());
            sum += glm::cross(polygon[b] - polygon[a], polygon[c] - polygon[a]);
        }
        ASSERT_LE(glm::length(sum - expected), 1e-9);
    }
}

TEST(PolygonCutter, takesTimeInProportionToConvexPolygons) {
    std::vector<glm::dvec3> polygon;
    constexpr int count = 200'000;
    for (int i = 0; i < count; ++i) polygon.emplace_back(std::cos(i * 6.283 / count), std::sin(i * 6.283 / count), 0);
    EXPECT_EQ(PolygonCutter{}.cut(polygon).size(), count - 2);
}

TEST(PolygonCutter, cutsACombOfManyTeeth) {
    std::vector<glm::dvec3> comb;
    constexpr int teeth = 60'000;
    for (int i = 0; i < teeth; ++i) comb.insert(comb.end(), {{2 * i, 9, 0}, {2 * i + 1, i % 3, 0}});
    for (int i = teeth; i-- > 0;) comb.insert(comb.end(), {{2 * i + 1, i % 3 - 1, 0}, {2 * i, 8, 0}});
    EXPECT_EQ(PolygonCutter{}.cut(comb).size(), comb.size() - 2);
}

}  // namespace
}  // namespace inkedge::polygons
