#include "lines/find/isolines.h"

#include <algorithm>
#include <map>
#include <numbers>

#include <gmock/gmock.h>

#include "scenes.h"

namespace inkedge::lines {
namespace {

using testing::IsEmpty;

// n x n cells of two triangles over the unit square; u and v are x and y less an offset, times a scale.
Mesh parametrised(std::uint32_t n, glm::dvec2 offset = {0, 0}, double scale = 1.0) {
    Mesh mesh;
    for (std::uint32_t j = 0; j <= n; ++j) {
        for (std::uint32_t i = 0; i <= n; ++i) {
            mesh.positions.emplace_back(double(i) / n, double(j) / n, 0.0);
            mesh.textureCoordinates.emplace_back((glm::dvec2{double(i) / n, double(j) / n} + offset) * scale);
        }
    }
    for (std::uint32_t j = 0; j < n; ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * (n + 1) + i;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, a + n + 1, a + n + 1, a + 1, a + n + 2});
        }
    }
    return mesh;
}

std::vector<IsolineSegment> isolinesOf(const Mesh& mesh, Isolines steps) {
    return findIsolines(mesh, mesh::buildTopology(mesh), steps);
}

double totalLength(const std::vector<IsolineSegment>& segments) {
    double sum = 0.0;
    for (const IsolineSegment& s : segments) sum += glm::distance(s.ends[0], s.ends[1]);
    return sum;
}

// How many chains there are that end, if no node has more than two ends.
std::size_t openChains(const std::vector<IsolineSegment>& segments) {
    std::map<std::uint32_t, int> ends;
    for (const IsolineSegment& s : segments)
        for (const std::uint32_t node : s.nodes) ++ends[node];
    std::size_t open = 0;
    for (const auto& [node, count] : ends) {
        EXPECT_LE(count, 2) << "at node " << node;
        open += count == 1 ? 1 : 0;
    }
    EXPECT_TRUE(ends.empty() || ends.rbegin()->first + 1 == ends.size()) << "numbers are left out";
    return open / 2;
}

TEST(Isolines, StandAtEachStepAcrossAllFaces) {
    // Offset by a thousandth, so that no step lies on an edge: 0.25, 0.5, 0.75 and 1 are passed, at x = u - 0.001.
    const auto segments = isolinesOf(parametrised(10, {0.001, 0.0}), {4, 0});
    EXPECT_NEAR(totalLength(segments), 4.0, 1e-5);
    EXPECT_EQ(openChains(segments), 4U);
    for (const IsolineSegment& s : segments) {
        EXPECT_EQ(s.coordinate, 0U);
        for (const glm::dvec3& end : s.ends) EXPECT_NEAR(end.x, 0.25 * s.step - 0.001, 1e-6);
    }
    EXPECT_TRUE(std::ranges::is_sorted(segments, {}, &IsolineSegment::triangle));
}

TEST(Isolines, AlongEdgesAreThereOnce) {
    // Steps of a quarter on cells of an eighth: every line follows edges, the sheet's borders included.
    const auto segments = isolinesOf(parametrised(8), {4, 2});
    EXPECT_NEAR(totalLength(segments), 5.0 + 3.0, 1e-5);
    EXPECT_EQ(segments.size(), 8U * 8U);
    EXPECT_EQ(openChains(segments), 8U);
}

TEST(Isolines, PassThroughCorners) {
    // A step for each point of the diagonals of cells whose u is x + y: lines go from corner to corner or along edges.
    Mesh mesh = parametrised(4);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.textureCoordinates[i].x = mesh.positions[i].x - mesh.positions[i].y;
    const auto segments = isolinesOf(mesh, {4, 0});
    EXPECT_NEAR(totalLength(segments), std::numbers::sqrt2 * (1.0 + 2.0 * (0.75 + 0.5 + 0.25)), 1e-5);
    EXPECT_EQ(openChains(segments), 7U);
}

TEST(Isolines, HaveTheirPositionInTheFace) {
    const Mesh mesh = parametrised(3, {0.1, 0.2}, 1.7);
    const auto segments = isolinesOf(mesh, {5, 7});
    ASSERT_GT(segments.size(), 20U);
    for (const IsolineSegment& s : segments) {
        for (std::size_t i = 0; i < 2; ++i) {
            glm::dvec3 position{0.0};
            glm::dvec2 uv{0.0};
            for (int k = 0; k < 3; ++k) {
                const std::uint32_t vertex = mesh.indices[3 * s.triangle + static_cast<std::uint32_t>(k)];
                EXPECT_GE(s.weights[i][k], 0.0);
                position += s.weights[i][k] * glm::dvec3{mesh.positions[vertex]};
                uv += s.weights[i][k] * glm::dvec2{mesh.textureCoordinates[vertex]};
            }
            EXPECT_LT(glm::distance(position, s.ends[i]), 1e-12);
            EXPECT_NEAR(uv[static_cast<int>(s.coordinate)] * (s.coordinate == 0 ? 5 : 7), s.step, 1e-9);
        }
    }
}

TEST(Isolines, GoOnAcrossASeamWhereBothSidesAgree) {
    // Two halves with vertices of their own; u goes on in the second, or starts anew.
    for (const bool agree : {true, false}) {
        Mesh mesh = parametrised(4, {0.001, 0.001});
        Mesh other = parametrised(4, {0.001, agree ? 1.001 : 0.1});
        for (glm::vec3& p : other.positions) p.y += 1.0F;
        if (!agree)
            for (glm::vec2& c : other.textureCoordinates) c.x += 0.1F;
        for (std::uint32_t& i : other.indices) i += static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
        mesh.textureCoordinates.insert(mesh.textureCoordinates.end(), other.textureCoordinates.begin(),
                                       other.textureCoordinates.end());
        mesh.indices.insert(mesh.indices.end(), other.indices.begin(), other.indices.end());
        EXPECT_EQ(openChains(isolinesOf(mesh, {2, 0})), agree ? 2U : 4U);
    }
}

TEST(Isolines, AreNoneWithoutCoordinatesOrChange) {
    Mesh mesh = parametrised(4);
    std::ranges::fill(mesh.textureCoordinates, glm::vec2{0.5F, 0.0F});
    EXPECT_THAT(isolinesOf(mesh, {2, 2}), IsEmpty());
    mesh.textureCoordinates.clear();
    EXPECT_THAT(isolinesOf(mesh, {2, 2}), IsEmpty());
    EXPECT_THAT(isolinesOf(parametrised(4), {0, 0}), IsEmpty());
}

TEST(Isolines, TooManyForAFaceAreLeftOut) {
    EXPECT_THAT(isolinesOf(parametrised(1, {0, 0}, 1e30), {1000, 1000}), IsEmpty());
    EXPECT_THAT(isolinesOf(parametrised(1, {0, 0}, 1e9), {1000, 1000}), IsEmpty());
    EXPECT_FALSE(isolinesOf(parametrised(1), {1000, 0}).empty());
}

TEST(Isolines, OfRepeatedFacesAreThereOnce) {
    Mesh mesh = parametrised(4, {0.01, 0.01});
    const double once = totalLength(isolinesOf(mesh, {3, 3}));
    mesh.indices.insert(mesh.indices.end(), mesh.indices.begin(), mesh.indices.begin() + 30);
    EXPECT_NEAR(totalLength(isolinesOf(mesh, {3, 3})), once, 1e-12);
}

}  // namespace
}  // namespace inkedge::lines
