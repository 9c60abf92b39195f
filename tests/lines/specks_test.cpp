#include "lines/specks.h"

#include <gmock/gmock.h>

namespace inkedge::lines {
namespace {

Line lineOf(const std::vector<glm::dvec2>& pixels, bool closed = false) {
    Line line;
    line.closed = closed;
    for (const glm::dvec2 pixel : pixels) line.points.push_back({pixel, {}});
    return line;
}

TEST(Specks, AreLinesUnderATenthOfAPixel) {
    std::vector<Line> lines{lineOf({{5, 5}, {5, 5}}),
                            lineOf({{5, 5}, {5.09, 5}}),
                            lineOf({{5, 5}, {5.06, 5}, {5, 5}}),
                            lineOf({{5, 5}, {5, 5.11}}),
                            lineOf({{5, 5}, {5.04, 5}, {5, 5.04}}, true),
                            lineOf({{5, 5}, {5.02, 5}, {5, 5.02}}, true),
                            lineOf({{0, 0}, {3, 4}})};
    leaveOutSpecks(lines);
    ASSERT_EQ(lines.size(), 4U);
    EXPECT_EQ(lines[0].points.size(), 3U);
    EXPECT_EQ(lines[1].points[1].pixel.y, 5.11);
    EXPECT_TRUE(lines[2].closed);
    EXPECT_EQ(lines[3].points[1].pixel.x, 3.0);
}

}  // namespace
}  // namespace inkedge::lines
