#include "curves/order_paths.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "curves/curves.h"

namespace inkedge::curves {
namespace {

using namespace curves;
using glm::dvec2;

// The way of a pen that is up, from the origin on.
double travel(const std::vector<Line>& lines) {
    double sum = 0.0;
    dvec2 pen{0.0};
    for (const Line& line : lines) {
        sum += glm::distance(pen, line.points.front().pixel);
        pen = (line.closed ? line.points.front() : line.points.back()).pixel;
    }
    return sum;
}

std::vector<Line> randomLines(int count, unsigned seed) {
    std::mt19937 random{seed};
    std::uniform_real_distribution<double> anywhere{0.0, 1000.0};
    std::uniform_real_distribution<double> near{-20.0, 20.0};
    std::vector<Line> lines;
    for (int i = 0; i < count; ++i) {
        const dvec2 start{anywhere(random), anywhere(random)};
        const dvec2 middle = start + dvec2{near(random), near(random)};
        const dvec2 end = middle + dvec2{near(random), near(random)};
        lines.push_back(i % 5 == 0 ? closedThrough({start, middle, end}) : lineThrough({start, middle, end}));
        lines.back().id = static_cast<std::uint32_t>(i + 1);
    }
    return lines;
}

std::vector<Line> inOrder(const std::vector<Line>& lines) {
    dvec2 pen{0.0};
    return inTravelOrder(lines, pen);
}

// A line's points whichever way it is drawn and, closed, wherever it begins.
std::set<std::pair<double, double>> pointsOf(const Line& line) {
    std::set<std::pair<double, double>> points;
    for (const LinePoint& p : line.points) points.emplace(p.pixel.x, p.pixel.y);
    return points;
}

TEST(TravelOrder, hasEveryLineOnceWithTheSamePoints) {
    for (const int count : {0, 1, 2, 500}) {
        const std::vector<Line> lines = randomLines(count, 1);
        const std::vector<Line> ordered = inOrder(lines);
        ASSERT_EQ(ordered.size(), lines.size());
        std::set<std::uint32_t> ids;
        for (const Line& line : ordered) {
            EXPECT_TRUE(ids.insert(line.id).second) << line.id;
            const Line& given = lines.at(line.id - 1);
            EXPECT_EQ(line.closed, given.closed);
            EXPECT_EQ(line.points.size(), given.points.size());
            EXPECT_EQ(pointsOf(line), pointsOf(given));
        }
    }
}

// n lines of random places are on a tour of about 0.7 sqrt(n area) by its shortest order; as they come each way is
// half of the side long.
TEST(TravelOrder, isAFractionOfTheOrderGiven) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const std::vector<Line> lines = randomLines(1000, seed);
        EXPECT_LT(travel(inOrder(lines)), 0.06 * travel(lines));
        EXPECT_LT(travel(inOrder(lines)), 0.8 * std::sqrt(1000.0 * 1e6));
    }
}

TEST(TravelOrder, drawsARowOfStrokesToAndFro) {
    // Ten strokes across, given from both ends in turn: the way between is one step each.
    std::vector<Line> lines;
    for (int i = 0; i < 10; ++i) {
        const double y = i % 2 == 0 ? i : 10 - i;
        lines.push_back(lineThrough({{0, y}, {100, y}}));
    }
    EXPECT_NEAR(travel(inOrder(lines)), 9.0, 1e-9);
}

TEST(TravelOrder, goesOnWhereALineEnds) {
    // A long line in pieces that are shuffled and turned round: the pen stays down.
    std::vector<Line> lines;
    for (int i = 0; i < 40; ++i) {
        const double x = 5.0 * ((i * 17) % 40);
        lines.push_back(i % 3 == 0 ? lineThrough({{x + 5, 0}, {x, 0}}) : lineThrough({{x, 0}, {x + 5, 0}}));
    }
    EXPECT_NEAR(travel(inOrder(lines)), 0.0, 1e-9);
}

TEST(TravelOrder, beginsAClosedLineWhereItIsNear) {
    const std::vector<Line> lines{closedThrough({{90, 90}, {10, 90}, {10, 10}, {90, 10}})};
    dvec2 pen{12, 8};
    const std::vector<Line> ordered = inTravelOrder(lines, pen);
    EXPECT_EQ(ordered[0].points[0].pixel, (dvec2{10, 10}));
    EXPECT_EQ(pen, (dvec2{10, 10})) << "where a closed line ends";
}

TEST(TravelOrder, exchangesWaysThatTheNearestEndLeavesLong) {
    // From the middle the nearest end leads away from what is left behind, which 2-opt mends.
    std::vector<PathEnds> dots;
    for (const double x : {0.0, -1.1, 2.3, -4.7, 9.5}) dots.push_back({{x, 0}, {x, 0}});
    const auto order = orderForTravel(dots, {-4.0, 0.0});
    dvec2 pen{-4.0, 0.0};
    double sum = 0.0;
    for (const auto& [index, reversed] : order) {
        sum += glm::distance(pen, dots[index].start);
        pen = dots[index].start;
    }
    EXPECT_NEAR(sum, 0.7 + 14.2, 1e-9);
}

TEST(TravelOrder, takesManyLinesInLittleTime) {
    const std::vector<Line> lines = randomLines(20'000, 4);
    EXPECT_LT(travel(inOrder(lines)), 0.02 * travel(lines));
}

}  // namespace
}  // namespace inkedge::curves
