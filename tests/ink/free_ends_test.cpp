#include "ink/free_ends.h"

#include <random>

#include <gmock/gmock.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge::ink {
namespace {

using testing::ElementsAre;

// Through pixels of the picture, in a parallel view of one unit per pixel: larger z is nearer.
Line lineAt(const std::vector<glm::dvec3>& points, LineType type = LineType::Outline) {
    Line line;
    line.type = type;
    for (const glm::dvec3& p : points) line.points.push_back({{p.x, p.y}, p});
    return line;
}

// Whether each line's first and last end are free.
std::vector<bool> freeEnds(std::vector<Line> all, const LineSettings& settings = {},
                           const PictureSettings& picture = {}) {
    Lines lines;
    lines.lines = std::move(all);
    lines.size = {200, 100};
    lines.camera.orthographicHeight = 100.0;
    const FreeEnds ends{lines, picture, settings};
    std::vector<bool> are;
    for (const Line& line : lines.lines) {
        are.push_back(ends.has(line.points.front()));
        are.push_back(ends.has(line.points.back()));
    }
    return are;
}

TEST(FreeEnds, AreNotWhereALineOfAnyTypeGoesOn) {
    EXPECT_THAT(freeEnds({lineAt({{10, 50, 0}, {60, 50, 0}})}), ElementsAre(true, true));
    EXPECT_THAT(freeEnds({lineAt({{10, 50, 0}, {60, 50, 0}}), lineAt({{110, 40, 0}, {60, 50, 0}}, LineType::Crease)}),
                ElementsAre(true, false, true, false));
    EXPECT_THAT(freeEnds({lineAt({{10, 50, 0}, {60, 50, 0}}), lineAt({{61.4, 50, 0}, {110, 50, 0}})}),
                ElementsAre(true, false, false, true));
    EXPECT_THAT(freeEnds({lineAt({{10, 50, 0}, {60, 50, 0}}), lineAt({{61.6, 50, 0}, {110, 50, 0}})}),
                ElementsAre(true, true, true, true));
}

TEST(FreeEnds, AreNotWhereALinePasses) {
    const Line crease = lineAt({{10, 50, 0}, {60, 50, 0}}, LineType::Crease);
    EXPECT_THAT(freeEnds({crease, lineAt({{90, 20, 0}, {60, 50, 0}, {90, 80, 0}})}),
                ElementsAre(true, false, true, true));
    EXPECT_THAT(freeEnds({crease, lineAt({{60, 0, 0}, {60, 99, 0}})}), ElementsAre(true, false, true, true));
    Line loop = lineAt({{60, 20, 0}, {90, 20, 0}, {90, 80, 0}, {60, 80, 0}});
    EXPECT_THAT(freeEnds({crease, loop}), ElementsAre(true, true, true, true));
    loop.closed = true;
    EXPECT_FALSE(freeEnds({crease, loop})[1]);
}

TEST(FreeEnds, AreWhereALineRunsBehindAnother) {
    const Line line = lineAt({{10, 50, 0}, {60, 50, 0}});
    EXPECT_TRUE(freeEnds({line, lineAt({{60, 20, 5}, {60, 80, 5}})})[1]);
    EXPECT_FALSE(freeEnds({line, lineAt({{60, 20, 3}, {60, 80, 3}})})[1]);
}

TEST(FreeEnds, AreNotWhereALineGoesOnSmoothlyAtAnyDepth) {
    const Line line = lineAt({{10, 50, 0}, {60, 50, 0}});
    EXPECT_FALSE(freeEnds({line, lineAt({{55, 50, 9}, {110, 58, 9}})})[1]);
    EXPECT_FALSE(freeEnds({line, lineAt({{60, 51, 9}, {110, 90, 9}})})[1]);
    EXPECT_TRUE(freeEnds({line, lineAt({{60, 51, 9}, {100, 99, 9}})})[1]);  // bent by over 45 degrees
}

TEST(FreeEnds, OfTwoLinesThatRunOutInOneTipAreFree) {
    EXPECT_THAT(freeEnds({lineAt({{10, 50, 0}, {60, 50, 0}}), lineAt({{10, 30, 0}, {60, 50, 0}})}),
                ElementsAre(true, true, true, true));
    EXPECT_THAT(freeEnds({lineAt({{10, 50, 0}, {60, 50, 0}}), lineAt({{10, 20, 0}, {60, 50, 0}})}),
                ElementsAre(true, false, true, false));
    // A speck is no line that goes on.
    EXPECT_TRUE(freeEnds({lineAt({{10, 50, 0}, {60, 50, 0}}), lineAt({{59.9, 50, 0}, {61, 50, 0}})})[1]);
}

TEST(FreeEnds, AreThoseBesideLinesThatAreNotDrawn) {
    const Line line = lineAt({{10, 50, 0}, {60, 50, 0}});
    Line other = lineAt({{60, 50, 0}, {110, 50, 0}}, LineType::Crease);
    PictureSettings outlines;
    outlines.lines = LineType::Outline;
    EXPECT_TRUE(freeEnds({line, other}, {}, outlines)[1]);
    other.visible = false;
    EXPECT_TRUE(freeEnds({line, other})[1]);
    LineSettings dashed;
    dashed.hidden = HiddenLines::Dashed;
    EXPECT_FALSE(freeEnds({line, other}, dashed)[1]);
}

TEST(FreeEnds, OfALineMayMeetTheLineItself) {
    // Like a b: its first end is free, its last one meets its own middle.
    EXPECT_THAT(freeEnds({lineAt({{50, 10, 0}, {50, 80, 0}, {80, 80, 0}, {80, 50, 0}, {50, 50, 0}})}),
                ElementsAre(true, false));
    EXPECT_THAT(freeEnds({lineAt({{50, 10, 0}, {50, 80, 0}, {99, 80, 0}, {50, 10, 0}})}), ElementsAre(false, false));
    EXPECT_THAT(freeEnds({lineAt({{50, 10, 0}, {51, 10, 0}, {52, 10.5, 0}, {60, 11, 0}})}), ElementsAre(true, true));
}

TEST(FreeEnds, AreThoseFarFromEveryOtherPiece) {
    std::mt19937 random{7};
    std::uniform_real_distribution<double> x{-20.0, 220.0};
    std::uniform_real_distribution<double> y{-20.0, 120.0};
    std::uniform_real_distribution<double> step{-25.0, 25.0};
    std::vector<Line> lines;
    for (int i = 0; i < 150; ++i) {
        const glm::dvec3 a{x(random), y(random), 0};
        const double reach = i % 10 == 0 ? 8.0 : 1.0;
        lines.push_back(
            lineAt({a, a + reach * glm::dvec3{i % 7 == 0 ? 0.0 : step(random), i % 5 == 0 ? 0.0 : step(random), 0}}));
    }
    std::vector<bool> expected;
    for (const Line& line : lines) {
        for (const glm::dvec2 end : {line.points.front().pixel, line.points.back().pixel}) {
            expected.push_back(std::ranges::none_of(lines, [&](const Line& other) {
                if (&other == &line) return false;
                const glm::dvec2 a = other.points[0].pixel;
                const glm::dvec2 along = other.points[1].pixel - a;
                const double share = glm::clamp(glm::dot(end - a, along) / glm::dot(along, along), 0.0, 1.0);
                const double distance = glm::distance(end, a + share * along);
                const glm::dvec2 outward =
                    glm::normalize(2.0 * end - line.points.front().pixel - line.points.back().pixel);
                const double cosine = glm::dot(outward, glm::normalize(along));
                const double ahead = glm::length(along) * (cosine > 0.0 ? 1.0 - share : share);
                if (std::abs(cosine) > 0.7 && ahead > 1.5) return distance <= 1.5;
                return distance <= 0.5 && (std::abs(cosine) <= 0.9 || ahead > 1.5);
            }));
        }
    }
    EXPECT_EQ(freeEnds(lines), expected);
    EXPECT_GT(std::ranges::count(expected, true), 60);
    EXPECT_GT(std::ranges::count(expected, false), 30);
}

}  // namespace
}  // namespace inkedge::ink
