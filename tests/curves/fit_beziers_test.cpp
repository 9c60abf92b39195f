#include "curves/fit_beziers.h"

#include <gmock/gmock.h>

#include "curves/curves.h"

namespace inkedge::curves {
namespace {

using namespace curves;
using glm::dvec2;

std::vector<dvec2> drawn(const std::vector<Bezier>& curves) {
    std::vector<dvec2> pixels{curves.front()[0]};
    constexpr int steps = 64;  // chords of curves up to 300 pixels stray by less than 0.02
    for (const Bezier& curve : curves) {
        for (int i = 1; i <= steps; ++i) pixels.push_back(pointAt(curve, static_cast<double>(i) / steps));
    }
    return pixels;
}

void expectJoined(const std::vector<Bezier>& curves) {
    for (std::size_t i = 1; i < curves.size(); ++i) EXPECT_EQ(curves[i][0], curves[i - 1][3]) << i;
    for (const Bezier& curve : curves) {
        for (const dvec2 p : curve) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
    }
}

double turnAt(const Bezier& before, const Bezier& after) {
    const dvec2 in = glm::normalize(before[3] - before[2]);
    const dvec2 out = glm::normalize(after[1] - after[0]);
    return std::acos(std::clamp(glm::dot(in, out), -1.0, 1.0));
}

TEST(FitBeziers, strayNoFurtherThanTheTolerance) {
    for (const double tolerance : {0.1, 0.25, 1.0}) {
        for (unsigned seed = 1; seed < 3; ++seed) {
            for (const double noise : {0.0, 0.2, 3.0}) {
                for (const int points : {9, 60, 400}) {
                    SCOPED_TRACE(testing::Message() << tolerance << ' ' << seed << ' ' << noise << ' ' << points);
                    const Line line = winding(points, noise, seed);
                    const auto curves = fitBeziers(line, tolerance);
                    ASSERT_FALSE(curves.empty());
                    expectJoined(curves);
                    EXPECT_EQ(curves.front()[0], line.points.front().pixel);
                    EXPECT_EQ(curves.back()[3], line.points.back().pixel);
                    EXPECT_LE(furthest(outlineOf(line), drawn(curves), 0.5), tolerance);
                }
            }
        }
    }
}

TEST(FitBeziers, drawACircleWithFewSmoothCurves) {
    const Line line = circle({200, 200}, 100.0, 720);
    const auto curves = fitBeziers(line, 0.25);
    expectJoined(curves);
    EXPECT_EQ(curves.front()[0], curves.back()[3]) << "closed";
    EXPECT_LE(curves.size(), 6U);  // four quarters stray 0.027, thirds 0.15; halves, 1.8
    EXPECT_LE(furthest(outlineOf(line), drawn(curves), 0.5), 0.25);
    for (std::size_t i = 0; i < curves.size(); ++i) {
        EXPECT_LT(turnAt(curves[i], curves[(i + 1) % curves.size()]), 1e-6) << "smooth, at the seam as well";
    }
}

TEST(FitBeziers, meetInTheCornersOfALine) {
    // A square with its closing corner in the middle of a side, then one that is rounded.
    const Line square = closedThrough({{50, 10}, {90, 10}, {90, 90}, {10, 90}, {10, 10}});
    const auto sides = fitBeziers(square, 0.25);
    ASSERT_EQ(sides.size(), 4U) << "four straight sides; the start within one is no corner";
    expectJoined(sides);
    EXPECT_EQ(sides.front()[0], sides.back()[3]);
    EXPECT_LE(furthest(outlineOf(square), drawn(sides), 0.5), 1e-9);

    std::vector<dvec2> pixels;  // two quarter circles that meet in a point, as an eye's outline does
    for (int i = 0; i <= 90; ++i) pixels.push_back({100 * std::cos(i * 0.0174533), 100 * std::sin(i * 0.0174533)});
    for (int i = 1; i <= 90; ++i) {
        pixels.push_back(
            {100 - 100 * std::cos(1.5707963 - i * 0.0174533), 100 - 100 * std::sin(1.5707963 - i * 0.0174533) + 0.0});
    }
    const auto eye = fitBeziers(lineThrough(pixels), 0.25);
    EXPECT_LE(eye.size(), 6U);
    EXPECT_LE(furthest(pixels, drawn(eye), 0.5), 0.25);
}

TEST(FitBeziers, areSmoothBetweenCorners) {
    const auto curves = fitBeziers(winding(700, 0.0, 2), 0.25);
    ASSERT_GT(curves.size(), 3U);
    EXPECT_LT(curves.size(), 40U);
    for (std::size_t i = 1; i < curves.size(); ++i) EXPECT_LT(turnAt(curves[i - 1], curves[i]), 1e-6) << i;
}

TEST(FitBeziers, keepAStraightLineOneCurve) {
    std::vector<dvec2> pixels;
    for (int i = 0; i <= 100; ++i) pixels.push_back({i * 3.0, 10.0 + i * 1.5});
    const auto curves = fitBeziers(lineThrough(pixels), 0.25);
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_LT(distanceToEdge(curves[0][1], pixels.front(), pixels.back()), 1e-9);
    EXPECT_LT(distanceToEdge(curves[0][2], pixels.front(), pixels.back()), 1e-9);
}

TEST(FitBeziers, takeLinesWithoutExtentAndRepeatedPoints) {
    EXPECT_TRUE(fitBeziers(lineThrough({}), 0.25).empty());
    EXPECT_EQ(fitBeziers(lineThrough({{1, 1}, {1, 1}}), 0.25).size(), 1U);
    EXPECT_EQ(fitBeziers(closedThrough({{1, 1}, {1, 1}, {1, 1}}), 0.25).size(), 1U);
    for (const Line& line :
         {lineThrough({{1, 1}, {9, 4}}), lineThrough({{1, 1}, {1, 1}, {9, 4}, {9, 4}}), closedThrough({{1, 1}, {9, 4}}),
          closedThrough({{1, 1}, {9, 4}, {1, 1}, {9, 4}}), lineThrough({{1, 1}, {9, 4}, {1, 1}}),
          circle({5, 5}, 0.01, 40), lineThrough({{0, 0}, {1e-9, 0}, {2e-9, 1e-9}})}) {
        const auto curves = fitBeziers(line, 0.25);
        ASSERT_FALSE(curves.empty());
        expectJoined(curves);
        EXPECT_LE(furthest(outlineOf(line), drawn(curves), 0.1), 0.25);
    }
    const double none = std::numeric_limits<double>::quiet_NaN();
    expectJoined(fitBeziers(lineThrough({{none, 1}, {2, 3}, {4, none}, {6, 7}, {9, 1}}), 0.25));
}

}  // namespace
}  // namespace inkedge::curves
