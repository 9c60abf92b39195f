#include "curves/simplify.h"

#include <gmock/gmock.h>

#include "curves/curves.h"

namespace inkedge::curves {
namespace {

using namespace curves;
using glm::dvec2;

std::vector<double> numbers(const Line& line) {
    std::vector<double> all;
    for (const LinePoint& p : line.points) all.push_back(p.position.x);
    return all;
}

TEST(Simplify, straysNoFurtherThanTheTolerance) {
    for (const double tolerance : {0.05, 0.25, 2.0}) {
        for (unsigned seed = 1; seed < 6; ++seed) {
            const Line line = winding(400, 0.4, seed);
            const Line simple = simplify(line, tolerance);
            EXPECT_LE(furthest(outlineOf(line), outlineOf(simple), 0.5), tolerance * (1.0 + 1e-9)) << seed;
            EXPECT_LT(simple.points.size(), line.points.size());
        }
    }
}

TEST(Simplify, keepsClosedLinesClosedAndWithinTheTolerance) {
    const Line line = circle({200, 200}, 100.0, 2000);
    const Line simple = simplify(line, 0.25);
    EXPECT_TRUE(simple.closed);
    EXPECT_LE(furthest(outlineOf(line), outlineOf(simple), 0.5), 0.25 * (1.0 + 1e-9));
    // A chord 0.25 within a circle of radius 100 spans 8.1 degrees: 45 of them; halves do not divide evenly.
    EXPECT_LE(simple.points.size(), 90U);
}

TEST(Simplify, keepsPointsWithTheirWorldPointsInOrder) {
    Line line = lineThrough({{0, 0}, {5, 0.01}, {10, 0}, {10, 5}, {10.01, 8}, {10, 10}});
    line.type = LineType::Crease;
    line.visible = false;
    line.object = 7;
    line.patch = 9;
    const Line simple = simplify(line, 0.1);
    EXPECT_THAT(numbers(simple), testing::ElementsAre(0.0, 2.0, 5.0));
    EXPECT_EQ(simple.points[1].pixel, (dvec2{10, 0}));
    EXPECT_EQ(simple.type, LineType::Crease);
    EXPECT_FALSE(simple.visible);
    EXPECT_EQ(simple.object, 7U);
    EXPECT_EQ(simple.patch, 9U);
}

TEST(Simplify, measuresToChordsSoThatASpikeAlongThemStays) {
    const Line simple = simplify(lineThrough({{0, 0}, {30, 0}, {10, 0}}), 0.25);
    EXPECT_THAT(numbers(simple), testing::ElementsAre(0.0, 1.0, 2.0));
}

TEST(Simplify, takesLinesWithoutExtent) {
    EXPECT_EQ(simplify(lineThrough({{1, 1}, {1, 1}}), 0.25).points.size(), 2U);
    EXPECT_EQ(simplify(lineThrough({{1, 1}, {1, 1}, {1, 1}, {1, 1}}), 0.25).points.size(), 2U);
    EXPECT_EQ(simplify(closedThrough({{1, 1}, {1, 1}, {1, 1}}), 0.25).points.size(), 2U);
    EXPECT_EQ(simplify(lineThrough({{1, 1}, {2, 2}}), 0.25).points.size(), 2U);
    EXPECT_EQ(simplify(lineThrough({}), 0.25).points.size(), 0U);
}

TEST(Simplify, leavesOutWhatIsNotFinite) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    const double far = std::numeric_limits<double>::infinity();
    EXPECT_THAT(numbers(simplify(lineThrough({{0, 0}, {none, 1}, {5, 5}, {6, far}, {0, 9}}), 0.25)),
                testing::ElementsAre(0.0, 2.0, 4.0));
}

TEST(Simplify, ofToleranceZeroKeepsTheLine) {
    const Line line = winding(100, 0.3, 3);
    EXPECT_EQ(numbers(simplify(line, 0.0)), numbers(line));
}

// A comb: each chord splits off one point, which costs the square of the points where nothing stands against it: 10^11
// steps, minutes.
TEST(Simplify, costsNoSquareOfThePoints) {
    std::vector<dvec2> pixels;
    for (int i = 0; i < 300'000; ++i) pixels.push_back({i * 1e-3, i % 2 == 0 ? 0.0 : 1000.0 - i * 1e-3});
    EXPECT_GT(simplify(lineThrough(pixels), 0.25).points.size(), pixels.size() / 2);
}

}  // namespace
}  // namespace inkedge::curves
