#include "lines/object_lines.h"

#include <numbers>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "scenes.h"

namespace inkedge::lines {
namespace {

using testing::IsEmpty;

Settings drawing(LineTypes types) {
    Settings settings;
    settings.picture.size = {400, 400};
    settings.picture.lines = types;
    settings.camera.direction = glm::dvec3{0.0, 0.0, -1.0};
    settings.camera.orthographicHeight = 0.0;
    return settings;
}

double length(const Line& line) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
        sum += glm::distance(line.points[i].position, line.points[i + 1].position);
    if (line.closed) sum += glm::distance(line.points.back().position, line.points.front().position);
    return sum;
}

// World length of the lines of one type that are seen.
double seen(const Mesh& mesh, LineType type, const Settings& settings) {
    const Scene scene = scenes::sceneOf(mesh);
    const Camera camera = frameCamera(scene, settings.camera, settings.picture.size);
    double sum = 0.0;
    for (const Line& line : ObjectLines{scene}.find(camera, settings).lines)
        if (line.type == type && line.visible) sum += length(line);
    return sum;
}

// Two by two about the origin, in z = 0: triangles (0, 1, 2) and (0, 2, 3).
Mesh sheet() {
    Mesh mesh = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    mesh.edges.resize(mesh.indices.size());
    return mesh;
}

// A roof over the sheet whose ridge is 45 degrees on both sides.
Mesh roof() {
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 1, 0}, {-1, 1, 0}};
    mesh.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    mesh.edges.resize(mesh.indices.size());
    return mesh;
}

constexpr std::size_t roofsRidge = 4;  // from 2 to 3, in the second triangle
constexpr double rounding = 1e-6;

TEST(MarkedEdges, AreLinesWhereNothingElseIs) {
    Mesh mesh = sheet();
    EXPECT_EQ(seen(mesh, LineType::Marked, drawing(standardLineTypes)), 0.0);
    mesh.edges[2] = EdgeKind::Marked;  // the diagonal, on one of its faces
    EXPECT_NEAR(seen(mesh, LineType::Marked, drawing(standardLineTypes)), 2.0 * std::numbers::sqrt2, rounding);
    EXPECT_EQ(seen(mesh, LineType::Marked, drawing(standardLineTypes - LineType::Marked)), 0.0);
}

TEST(TangentEdges, AreLinesThatCanBeLeftOut) {
    Mesh mesh = sheet();
    mesh.edges[2] = EdgeKind::Tangent;
    EXPECT_NEAR(seen(mesh, LineType::Tangent, drawing(standardLineTypes)), 2.0 * std::numbers::sqrt2, rounding);
    EXPECT_EQ(seen(mesh, LineType::Tangent, drawing(standardLineTypes - LineType::Tangent)), 0.0);
    EXPECT_EQ(seen(mesh, LineType::Crease, drawing(standardLineTypes)), 0.0);
}

TEST(TangentEdges, AreNoCreasesHoweverFarTheyBend) {
    Mesh mesh = roof();
    mesh.edges[roofsRidge] = EdgeKind::Tangent;
    EXPECT_NEAR(seen(mesh, LineType::Tangent, drawing(standardLineTypes)), 2.0, rounding);
    EXPECT_EQ(seen(mesh, LineType::Crease, drawing(standardLineTypes)), 0.0);
    mesh.edges[roofsRidge] |= EdgeKind::Seam;
    mesh.edges[roofsRidge] -= EdgeKind::Tangent;
    EXPECT_EQ(seen(mesh, LineType::Tangent, drawing(standardLineTypes)), 0.0);
    EXPECT_EQ(seen(mesh, LineType::Crease, drawing(standardLineTypes)), 0.0);
}

TEST(MarkedEdges, AreCreasesOnlyWhereMarkedLinesAreNotDrawn) {
    Mesh mesh = roof();
    EXPECT_NEAR(seen(mesh, LineType::Crease, drawing(standardLineTypes)), 2.0, rounding);
    mesh.edges[roofsRidge] = EdgeKind::Marked;
    EXPECT_NEAR(seen(mesh, LineType::Marked, drawing(standardLineTypes)), 2.0, rounding);
    EXPECT_EQ(seen(mesh, LineType::Crease, drawing(standardLineTypes)), 0.0);
    EXPECT_NEAR(seen(mesh, LineType::Crease, drawing(LineType::Crease)), 2.0, rounding);
}

TEST(MarkedEdges, AreOutlinesUnlessThoseAreNotDrawn) {
    Mesh mesh = sheet();
    mesh.edges[0] = EdgeKind::Marked;  // from (-1, -1) to (1, -1)
    EXPECT_NEAR(seen(mesh, LineType::Outline, drawing(standardLineTypes)), 8.0, rounding);
    EXPECT_EQ(seen(mesh, LineType::Marked, drawing(standardLineTypes)), 0.0);
    EXPECT_NEAR(seen(mesh, LineType::Marked, drawing(LineType::Marked)), 2.0, rounding);
}

TEST(Isolines, AreLinesOfTheirOwnWhoseStepsMayChange) {
    Mesh mesh = sheet();
    mesh.edges.clear();
    for (const glm::vec3 p : mesh.positions) mesh.textureCoordinates.emplace_back(0.5F * p.x + 0.4F, 0.5F * p.y + 0.4F);
    const Scene scene = scenes::sceneOf(mesh);
    const ObjectLines lines{scene};
    Settings settings = drawing(standardLineTypes);
    const Camera camera = frameCamera(scene, settings.camera, settings.picture.size);
    const auto isolines = [&](Isolines steps) {
        settings.lines.isolines = steps;
        std::vector<double> lengths;
        for (const Line& line : lines.find(camera, settings).lines)
            if (line.type == LineType::Isoparametric) lengths.push_back(length(line));
        return lengths;
    };
    // From -0.1 to 0.9: 0, 1/4, 1/2 and 3/4; 0 and 1/2. Each goes across both faces in one.
    EXPECT_THAT(isolines({4, 0}), testing::ElementsAreArray(std::vector(4, testing::DoubleNear(2.0, rounding))));
    EXPECT_THAT(isolines({4, 2}), testing::SizeIs(6));
    EXPECT_THAT(isolines({0, 2}), testing::SizeIs(2));
    settings.picture.lines = standardLineTypes - LineType::Isoparametric;
    EXPECT_THAT(isolines({4, 4}), IsEmpty());
}

TEST(Isolines, OnTheBackOfASolidAreNotSeen) {
    Mesh mesh = scenes::sphere();
    for (const glm::vec3 p : mesh.positions) mesh.textureCoordinates.emplace_back(0.5F * p.y + 0.25F, 0.0F);
    Settings settings = drawing(standardLineTypes);
    settings.lines.isolines = {1, 0};  // at y = -0.5: a circle, seen from its level
    // Half a circle of radius sqrt(3) / 2; facets are shorter than arcs by (pi / 64)^2 / 6, and the eye sees a little
    // less.
    const double half = std::numbers::pi * 0.5 * std::numbers::sqrt3;
    const double length = seen(mesh, LineType::Isoparametric, settings);
    EXPECT_GT(length, 0.85 * half);
    EXPECT_LT(length, 1.05 * half);
}

}  // namespace
}  // namespace inkedge::lines
