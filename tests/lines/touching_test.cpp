#include "lines/see/touching.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;
using testing::IsEmpty;
using testing::Not;

constexpr double pixelsPerUnit = 30.0;
// Parts of a line are judged at points, and cut between them to a tenth of a pixel.
constexpr double cuts = 1.0;

Camera fromAbove() { return orthographic({0, 8, 0}, 300.0 / pixelsPerUnit); }

double lengthOf(const std::vector<Line>& lines, LineTypes types) {
    return length(thoseOf(lines, [&](const Line& line) { return types.contains(line.type); }));
}

TEST(Touching, ASheetHasABorderHoweverNearItLiesOnASurface) {
    for (const double gap : {0.0, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
        for (const Size size : {Size{400, 300}, Size{1600, 1200}}) {
            const Scene scene =
                sceneOf({{box({6, 1, 6}), translation({0, -0.5, 0})}, {sheet(2), translation({0, gap, 0})}});
            const auto lines = linesOf(scene, fromAbove(), {.size = size});
            const double scale = size.height / 300.0;
            EXPECT_NEAR(lengthOf(lines, LineType::Boundary | LineType::Intersection), 8 * pixelsPerUnit * scale,
                        cuts * scale)
                << "gap " << gap << ", height " << size.height;
            EXPECT_NEAR(lengthOf(lines, LineType::Outline), 24 * pixelsPerUnit * scale, cuts * scale);
        }
    }
}

TEST(Touching, SheetsThatGoOnInEachOtherHaveASeam) {
    const Scene scene = sceneOf({{sheet(2), glm::dmat4{1.0}}, {sheet(2), translation({2, 0, 0})}});
    const auto lines = linesOf(scene, fromAbove());
    EXPECT_NEAR(length(lines), 12 * pixelsPerUnit, cuts);
    EXPECT_NEAR(lengthOf(lines, LineType::Outline), 12 * pixelsPerUnit, cuts);
}

TEST(Touching, ContactsAreIntersectionsAlongTheirWholeLength) {
    const Scene scene = sceneOf({{cube(), glm::dmat4{1.0}}, {cube(), translation({2, 0, 0})}});
    constexpr double tenthOfAPixel = 5e-3;  // units, in these views: parts end so near to where they change
    const auto isContact = [&](const Line& line) {
        return std::ranges::all_of(line.points,
                                   [&](const LinePoint& p) { return std::abs(p.position.x - 1.0) < tenthOfAPixel; });
    };
    for (const glm::dvec3 eye : {glm::dvec3{6, 4, 7}, glm::dvec3{-4, 5, 6}, glm::dvec3{1, 6, -8}}) {
        const auto contacts = thoseOf(linesOf(scene, perspective(eye, {1, 0, 0})), isContact);
        EXPECT_THAT(contacts, Not(IsEmpty()));
        for (const Line& line : contacts) EXPECT_EQ(line.type, LineType::Intersection);
    }
}

TEST(Touching, EdgesThatTouchAFaceFromBehindAreNotSeen) {
    const glm::dmat4 onItsEdge = translation({0, -std::sqrt(2.0), 0}) * rotation(45.0, {0, 0, 1});
    const glm::dmat4 upright = translation({0, -1, 0}) * rotation(90.0, {0, 0, 1});
    for (const auto& [mesh, transform] : {std::pair{cube(), onItsEdge}, std::pair{sheet(2), upright}}) {
        for (const double gap : {0.0, 1e-7, -1e-7, 1e-6}) {
            const Scene scene = sceneOf({{sheet(6), glm::dmat4{1.0}}, {mesh, translation({0, -gap, 0}) * transform}});
            for (const glm::dvec3 eye : {glm::dvec3{0, 8, 0}, glm::dvec3{3, 8, 2}}) {
                const auto lines = linesOf(scene, orthographic(eye, 300.0 / pixelsPerUnit));
                EXPECT_THAT(thoseOf(lines, [](const Line& line) { return line.object == 2; }), IsEmpty())
                    << mesh.name << ", gap " << gap;
            }
            const auto below = linesOf(scene, orthographic({3, -8, 2}, 300.0 / pixelsPerUnit));
            EXPECT_GT(length(thoseOf(below, [](const Line& line) { return line.object == 2; })), 4 * pixelsPerUnit);
        }
    }
}

}  // namespace
}  // namespace inkedge::lines
