#include "lines/object_lines.h"

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#ifdef __linux__
#include <sched.h>
#endif

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;
using testing::IsEmpty;

void expectSame(const std::vector<Line>& one, const std::vector<Line>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].type, other[i].type);
        EXPECT_EQ(one[i].visible, other[i].visible);
        EXPECT_EQ(one[i].closed, other[i].closed);
        EXPECT_EQ(one[i].object, other[i].object);
        EXPECT_EQ(one[i].patch, other[i].patch);
        ASSERT_EQ(one[i].points.size(), other[i].points.size());
        for (std::size_t k = 0; k < one[i].points.size(); ++k) {
            ASSERT_EQ(one[i].points[k].pixel, other[i].points[k].pixel);
            ASSERT_EQ(one[i].points[k].position, other[i].points[k].position);
        }
    }
}

TEST(ObjectLines, ThatAreSeenAreTheSameWhereHiddenOnesAreWantedToo) {
    const Scene scene =
        sceneOf({{torus(2.0, 0.8, 90, 40), glm::dmat4{1.0}}, {cube(1.0), translation({0.5, 0.3, 0.2})}});
    for (const Camera& camera : {perspective({7, 4, 5}), perspective({6, 1, -5})}) {
        for (const Contour contour : bothContours) {
            const auto without = linesOf(scene, camera, {.contour = contour});
            const auto with = linesOf(scene, camera, {.contour = contour, .hidden = HiddenLines::Dashed});
            EXPECT_THAT(without, testing::Not(IsEmpty()));
            EXPECT_THAT(without, testing::Not(IsEmpty()));
            EXPECT_LT(without.size(), with.size());
            expectSame(thoseOf(with, [](const Line& line) { return line.visible; }), without);
        }
    }
}

TEST(ObjectLines, OfPartlyHiddenLoopsBeginWhereTheyAreHidden) {
    // A square sheet behind a post: one open line all round, whatever corner its chain begins at.
    for (int turn = 0; turn < 4; ++turn) {
        const Scene scene =
            sceneOf({{sheet(4.0), rotation(90.0 * turn, {0, 1, 0})}, {box({1, 4, 1}), translation({0.3, 2.5, 2})}});
        const auto lines = linesOf(scene, perspective({0, 6, 12}));
        const auto onSheet =
            thoseOf(lines, [](const Line& line) { return line.object == 1 && line.type == LineType::Outline; });
        ASSERT_THAT(onSheet, testing::Not(IsEmpty()));
        EXPECT_LE(onSheet.size(), 2U) << turn;
    }
}

void expectSane(const std::vector<Line>& lines) {
    for (const Line& line : lines) {
        EXPECT_GE(line.points.size(), 2U);
        for (const LinePoint& p : line.points) {
            EXPECT_TRUE(std::isfinite(p.pixel.x) && std::isfinite(p.pixel.y));
            EXPECT_TRUE(std::isfinite(p.position.x) && std::isfinite(p.position.y) && std::isfinite(p.position.z));
        }
    }
}

TEST(ObjectLines, OfWhatLiesBehindTheCameraAreNone) {
    const Scene scene = sceneOf({{sphere(1.0, 32), glm::dmat4{1.0}}, {sheet(2.0), translation({0, 2, 0})}});
    EXPECT_THAT(linesOf(scene, perspective({0, 0, 10}, {0, 0, 20}), {.hidden = HiddenLines::Solid}), IsEmpty());
    EXPECT_THAT(linesOf(scene, orthographic({0, 0, 10}, 5.0, {0, 0, 20}), {.hidden = HiddenLines::Solid}), IsEmpty());
    EXPECT_THAT(linesOf(scene, perspective({0, 0, 10}, {10, 0, 10})), IsEmpty()) << "beside the picture";
}

TEST(ObjectLines, FromWithinAModelAreThoseOfItsInside) {
    // Within a cube, looking at its far face: its four edges and parts of the four that run towards the eye.
    const Scene scene = sceneOf(cube(2.0));
    const auto lines = linesOf(scene, perspective({0, 0, 0}, {0, 0, -1}, 100.0));
    expectSane(lines);
    for (const Line& line : lines) EXPECT_EQ(line.type, LineType::Crease);
    const double side = 2.0 * 150.0 / std::tan(glm::radians(50.0));
    double across = 0.0;
    for (const Line& line : lines)
        forEachPiece(line, [&](const LinePoint& p, const LinePoint& q) {
            if (p.position.z == -1.0 && q.position.z == -1.0) across += glm::distance(p.pixel, q.pixel);
        });
    EXPECT_NEAR(across, 4.0 * side, 1e-6);
    for (const Contour contour : bothContours) {
        expectSane(
            linesOf(sceneOf(torus(2.0, 0.8, 60, 30)), perspective({2, 0, 0}, {2, 0, 5}, 90.0), {.contour = contour}));
        expectSane(linesOf(sceneOf(sphere(1.0, 32)), perspective({0, 0, 0.9}, {0, 0, 2}, 90.0), {.contour = contour}));
    }
}

TEST(ObjectLines, OfMeshesWithFaultsAreThoseOfTheMeshWithout) {
    const Camera camera = perspective({5, 4, 7});
    const Mesh whole = cube(2.0);
    const double expected = length(linesOf(sceneOf(whole), camera));
    Mesh twice = whole;  // every face again, some turned over
    for (std::size_t i = 0; i < whole.indices.size(); i += 3) {
        const bool turned = i % 2 == 1;
        for (const std::size_t k : {0U, turned ? 2U : 1U, turned ? 1U : 2U})
            twice.indices.push_back(whole.indices[i + k]);
    }
    EXPECT_NEAR(length(linesOf(sceneOf(twice), camera)), expected, 1e-6);
    Mesh thin = whole;  // faces collapsed to points and to edges
    thin.indices.insert(thin.indices.end(), {0, 0, 0, 1, 1, 3, 7, 5, 7});
    EXPECT_NEAR(length(linesOf(sceneOf(thin), camera)), expected, 1e-6);
    EXPECT_NEAR(length(linesOf(sceneOf({{whole, glm::dmat4{1.0}}, {whole, scaling({0, 0, 0})}}), camera)), expected,
                1e-6);
}

TEST(ObjectLines, OfManyFacesAtOneEdgeHoldTheEdgeOnce) {
    // Four pages of a book; its back is seen between them.
    Mesh book;
    book.name = "book";
    book.positions = {{0, -1, 0}, {0, 1, 0}};
    for (int page = 0; page < 4; ++page) {
        const double angle = glm::radians(30.0 + 40.0 * page);
        const auto first = static_cast<std::uint32_t>(book.positions.size());
        book.positions.emplace_back(2 * std::cos(angle), -1, 2 * std::sin(angle));
        book.positions.emplace_back(2 * std::cos(angle), 1, 2 * std::sin(angle));
        book.indices.insert(book.indices.end(), {0, first, first + 1, 0, first + 1, 1});
    }
    const Camera camera = perspective({0.2, 0, 9});
    const auto lines = linesOf(sceneOf(book), camera);
    double back = 0.0;
    for (const Line& line : lines)
        forEachPiece(line, [&](const LinePoint& p, const LinePoint& q) {
            if (std::abs(p.position.x) < 1e-9 && std::abs(q.position.x) < 1e-9)
                back += glm::distance(p.position, q.position);
        });
    EXPECT_NEAR(back, 2.0, 1e-6);
}

TEST(ObjectLines, FitAnyPicture) {
    const Scene scene = sceneOf({{sphere(1.0, 24), glm::dmat4{1.0}}, {cube(1.0), translation({1, 0, 0})}});
    for (const Size size : {Size{1, 1}, Size{1, 700}, Size{9000, 1}, Size{8, 8}})
        for (const Contour contour : bothContours)
            expectSane(linesOf(scene, perspective({3, 2, 6}), {.size = size, .contour = contour}));
    EXPECT_THAT(linesOf(scene, perspective({3, 2, 6}), {.size = {1, 1}}), testing::Not(IsEmpty()));
}

TEST(ObjectLines, FarFromTheOriginAreThoseNearIt) {
    const glm::dvec3 far{4.5e5, -5.2e6, 120.0};  // a surveyor's
    Mesh there = torus(2.0, 0.8, 90, 40);
    there.origin = far;
    const Camera near = perspective({7, 4, 5});
    const Camera camera = perspective(far + glm::dvec3{7, 4, 5}, far);
    const auto expected = linesOf(sceneOf(torus(2.0, 0.8, 90, 40)), near);
    const auto found = linesOf(sceneOf(there), camera);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        ASSERT_EQ(found[i].points.size(), expected[i].points.size());
        for (std::size_t k = 0; k < found[i].points.size(); ++k)
            EXPECT_LT(glm::distance(found[i].points[k].pixel, expected[i].points[k].pixel), 1e-3);  // doubles at 5e6
    }
}

TEST(ObjectLines, AreTheSameForAnyNumberOfThreadsAndAnyNumberOfTimes) {
    // Over 200,000 faces, which the threads share.
    const Scene scene = sceneOf({{torus(2.0, 0.8, 500, 220), glm::dmat4{1.0}},
                                 {sphere(1.0, 64), translation({1.5, 0.5, 0})},
                                 {sheet(6.0, 20), rotation(5, {1, 0, 1})}});
    const Camera camera = perspective({7, 4, 5});
    const LineOptions options{.hidden = HiddenLines::Solid};
    const ObjectLines prepared{scene};
    const auto expected = prepared.find(camera, settingsOf(options)).lines;
    EXPECT_GT(expected.size(), 10U);
    expectSame(prepared.find(camera, settingsOf(options)).lines, expected);
    expectSame(linesOf(scene, camera, options), expected);
#ifdef __linux__
    cpu_set_t all;
    ASSERT_EQ(sched_getaffinity(0, sizeof all, &all), 0);
    cpu_set_t one;
    CPU_ZERO(&one);
    for (std::size_t cpu = 0; cpu < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++cpu)
        if (CPU_ISSET(cpu, &all)) CPU_SET(cpu, &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    const auto alone = linesOf(scene, camera, options);
    ASSERT_EQ(sched_setaffinity(0, sizeof all, &all), 0);
    expectSame(alone, expected);
#endif
}

}  // namespace
}  // namespace inkedge::lines
