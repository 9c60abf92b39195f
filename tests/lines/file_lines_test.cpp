// Lines that a file has besides triangles.
#include <gmock/gmock.h>

#include "lines/coincident.h"
#include "lines/specks.h"
#include "lines/views.h"

namespace inkedge::lines {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

constexpr double exact = 1e-3;  // pixels: how far an end may be off that no ray decides
constexpr double seen = 0.5;    // pixels: where a line goes behind a surface is found by rays

// From the front, 100 pixels a unit: pixel x = 200 + 100 x, y = 150 - 100 y.
const Camera front = views::orthographic({0, 0, 10}, 3.0);

Mesh linesMesh(const std::vector<glm::vec3>& lines) {
    Mesh mesh;
    mesh.name = "lines";
    mesh.lines = lines;
    return mesh;
}

std::vector<Line> markedOf(const Scene& scene, HiddenLines hidden = HiddenLines::None) {
    return views::thoseOf(
        views::linesOf(scene, front, {.size = {400, 300}, .contour = Contour::Auto, .hidden = hidden}),
        LineType::Marked);
}

TEST(FileLines, AreDrawnWithoutAnyTriangle) {
    const std::vector<Line> lines = markedOf(scenes::sceneOf(linesMesh({{-1, 0, 0}, {1, 0.5F, 0}})));
    ASSERT_THAT(lines, SizeIs(1));
    EXPECT_TRUE(lines[0].visible);
    EXPECT_EQ(lines[0].object, 1U);
    EXPECT_EQ(lines[0].patch, 0U);
    ASSERT_THAT(lines[0].points, SizeIs(2));
    const glm::dvec2 left = lines[0].points[0].pixel.x < 200 ? lines[0].points[0].pixel : lines[0].points[1].pixel;
    EXPECT_NEAR(left.x, 100, exact);
    EXPECT_NEAR(left.y, 150, exact);
}

TEST(FileLines, GoOnIntoEachOtherAndClose) {
    const glm::vec3 a{-1, -1, 0};
    const glm::vec3 b{1, -1, 0};
    const glm::vec3 c{0, 1, 0};
    const std::vector<Line> open = markedOf(scenes::sceneOf(linesMesh({a, b, b, c})));
    ASSERT_THAT(open, SizeIs(1));
    EXPECT_THAT(open[0].points, SizeIs(3));
    const std::vector<Line> closed = markedOf(scenes::sceneOf(linesMesh({a, b, c, b, a, c})));
    ASSERT_THAT(closed, SizeIs(1));
    EXPECT_TRUE(closed[0].closed);
    EXPECT_THAT(closed[0].points, SizeIs(3));
}

TEST(FileLines, AreHiddenBehindSurfacesAndHideNone) {
    Mesh mesh = scenes::box({1, 1, 1});
    mesh.lines = {{-1.5F, 0, -2}, {1.5F, 0, -2}};  // behind the box
    const Scene scene = scenes::sceneOf(mesh);
    EXPECT_NEAR(views::length(markedOf(scene)), 200, 2 * seen);
    const std::vector<Line> all = markedOf(scene, HiddenLines::Solid);
    EXPECT_NEAR(views::length(views::thoseOf(all, [](const Line& line) { return !line.visible; })), 100, 2 * seen);
    mesh.lines = {{-1.5F, 0, 2}, {1.5F, 0, 2}};  // before it
    const std::vector<Line> before = views::linesOf(scenes::sceneOf(mesh), front);
    EXPECT_NEAR(views::length(views::thoseOf(before, LineType::Marked)), 300, exact);
    EXPECT_NEAR(views::length(views::thoseOf(before, LineType::Outline)), 400, seen);
}

TEST(FileLines, AreSeenWhereTheyLieOnASurfaceOrItsEdges) {
    Mesh mesh = scenes::box({1, 1, 1});
    mesh.lines = {{-0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}, {-0.5F, -0.5F, 0.5F}, {0.5F, 0.25F, 0.5F}};
    const double inclined = 100 * std::sqrt(1.0 + 0.75 * 0.75);
    Settings settings = views::settingsOf({});
    settings.picture.lines = LineType::Marked;  // else the first is a part of the outline
    const Lines found = ObjectLines{scenes::sceneOf(mesh)}.find(front, settings);
    EXPECT_NEAR(views::length(views::thoseOf(found.lines, LineType::Marked)), 100 + inclined, exact);
}

TEST(FileLines, StandWhereTheirInstancesDo) {
    const Mesh mesh = linesMesh({{0, 0, 0}, {1, 0, 0}});
    glm::dmat4 flat{1.0};
    flat[1] = glm::dvec4{0.0};  // no triangle would show
    flat[0] *= 0.5;
    flat[3].y = -1.0;
    EXPECT_NEAR(views::length(markedOf(scenes::sceneOf({{mesh, glm::dmat4{1.0}}, {mesh, flat}}))), 150, exact);
}

TEST(FileLines, AreMarkedLinesAmongOthers) {
    Mesh mesh = scenes::box({1, 1, 1});
    mesh.lines = {{-1.5F, 0, -2}, {1.5F, 0, -2}};
    const Scene scene = scenes::sceneOf(mesh);
    Settings settings = views::settingsOf({});
    const Lines marked = ObjectLines{scene}.findBesidePixels(front, settings);
    EXPECT_THAT(marked.lines, SizeIs(2));
    EXPECT_THAT(views::thoseOf(marked.lines, LineType::Marked), SizeIs(2));
    settings.picture.lines = standardLineTypes - LineType::Marked;
    EXPECT_THAT(ObjectLines{scene}.findBesidePixels(front, settings).lines, IsEmpty());
    EXPECT_THAT(views::thoseOf(ObjectLines{scene}.find(front, settings).lines, LineType::Marked), IsEmpty());
}

TEST(FileLines, AreSeenOnTheFloorThatThePicturesEyeStandsOver) {
    Mesh floor = scenes::quad({-50, 0, 50}, {50, 0, 50}, {50, 0, -50}, {-50, 0, -50});
    floor.lines = {{-0.3F, 0, 40}, {0.7F, 0, -40}};  // from behind the eye to far before it
    const Camera camera = views::perspective({0, 1, 10}, {0, 0.4, 0});
    const std::vector<Line> lines =
        views::thoseOf(views::linesOf(scenes::sceneOf(floor), camera, {.size = {400, 300}}), LineType::Marked);
    ASSERT_THAT(lines, SizeIs(1));
    EXPECT_TRUE(lines[0].visible);
}

TEST(FileLines, AreDrawnOnceHoweverOftenTheFileHasThem) {
    const glm::vec3 a{-1, 0, 0};
    const glm::vec3 b{1, 0, 0};
    const Scene scene = scenes::sceneOf(linesMesh({a, b, b, a, a, b}));
    for (const CoincidentLines coincident : {CoincidentLines::Merge, CoincidentLines::Keep}) {
        Settings settings = views::settingsOf({});
        settings.lines.coincident = coincident;
        const Lines found = ObjectLines{scene}.find(front, settings);
        ASSERT_THAT(found.lines, SizeIs(1));
        EXPECT_FALSE(found.lines[0].closed);
        EXPECT_NEAR(views::length(found.lines), 200, exact);
    }
}

TEST(FileLines, AlongOtherLinesAreThoseUnlessAllAreKept) {
    Mesh mesh = scenes::box({1, 1, 1});
    mesh.lines = {{-0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}, {-0.5F, -0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}};
    const Scene scene = scenes::sceneOf(mesh);
    Settings settings = views::settingsOf({});
    const double diagonal = 100 * std::sqrt(2.0);
    const auto lengthOf = [&](LineType type) {
        return views::length(views::thoseOf(ObjectLines{scene}.find(front, settings).lines, type));
    };
    const double atEnds = 2 * std::sqrt(2.0) * coincidentWithin;  // as near to the outline as that it is a part of it
    EXPECT_NEAR(lengthOf(LineType::Marked), diagonal, atEnds);
    EXPECT_NEAR(lengthOf(LineType::Outline), 400, exact);
    EXPECT_NEAR(views::length(ObjectLines{scene}.findBesidePixels(front, settings).lines), diagonal, atEnds);
    settings.lines.coincident = CoincidentLines::Keep;
    EXPECT_NEAR(lengthOf(LineType::Marked), 100 + diagonal, exact);
    settings.lines.coincident = CoincidentLines::Merge;
    settings.picture.lines = LineType::Marked;
    EXPECT_NEAR(lengthOf(LineType::Marked), 100 + diagonal, exact);
}

TEST(FileLines, SeenEndOnAreSpecks) {
    std::vector<Line> lines =
        markedOf(scenes::sceneOf(linesMesh({{0.3F, 0.2F, -1}, {0.3F, 0.2F, 1}, {0, 0, 0}, {1, 0, 0}})));
    leaveOutSpecks(lines);
    EXPECT_NEAR(views::length(lines), 100, exact);
    EXPECT_THAT(lines, SizeIs(1));
}

TEST(FileLines, OfNoLengthAreNone) {
    EXPECT_THAT(markedOf(scenes::sceneOf(linesMesh({{0, 0, 0}, {0, 0, 0}, {-1, 0, 0}, {1, 0, 0}}))), SizeIs(1));
}

}  // namespace
}  // namespace inkedge::lines
