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

Line typed(LineType type, const std::vector<glm::dvec2>& pixels, std::uint32_t object = 1) {
    Line line = lineOf(pixels);
    line.type = type;
    line.object = object;
    return line;
}

std::size_t keptOf(std::vector<Line> lines) {
    leaveOutScraps(lines);
    return lines.size();
}

const Line longCrease = typed(LineType::Crease, {{0, 50}, {40, 50}});

TEST(Scraps, AreShortLinesThatReachNoOther) {
    for (const LineType type : {LineType::Crease, LineType::Occlusion, LineType::Boundary, LineType::Intersection})
        EXPECT_EQ(keptOf({longCrease, typed(type, {{5, 5}, {7.9, 5}})}), 1U);
    for (const LineType type : {LineType::Marked, LineType::Isoparametric, LineType::Object})
        EXPECT_EQ(keptOf({longCrease, typed(type, {{5, 5}, {7.9, 5}})}), 2U);
    EXPECT_EQ(keptOf({longCrease, typed(LineType::Crease, {{5, 5}, {8.1, 5}})}), 2U) << "long enough";
    Line loop = typed(LineType::Crease, {{5, 5}, {5.9, 5}, {5.9, 5.8}});
    loop.closed = true;
    EXPECT_EQ(keptOf({longCrease, loop}), 1U);
}

TEST(Scraps, StayWhereTheyJoinAnotherLine) {
    EXPECT_EQ(keptOf({longCrease, typed(LineType::Crease, {{20, 50}, {20, 48}})}), 2U) << "in its middle";
    EXPECT_EQ(keptOf({longCrease, typed(LineType::Crease, {{20, 48.6}, {20, 47}})}), 2U) << "across a gap";
    EXPECT_EQ(keptOf({longCrease, typed(LineType::Crease, {{20, 48.4}, {20, 47}})}), 1U);
    // Dashes of one line, or one that changes its type.
    EXPECT_EQ(keptOf({typed(LineType::Crease, {{5, 5}, {7, 5}}), typed(LineType::Occlusion, {{8, 5}, {9.5, 5}})}), 2U);
    EXPECT_EQ(keptOf({typed(LineType::Crease, {{5, 5}, {6, 5}}), typed(LineType::Occlusion, {{7, 5}, {8, 5}})}), 0U);
}

TEST(Scraps, AreNotTheOutlinesOfTinyThings) {
    EXPECT_EQ(keptOf({longCrease, typed(LineType::Outline, {{5, 5}, {7, 5}}, 2)}), 2U);
    EXPECT_EQ(keptOf({longCrease, typed(LineType::Outline, {{5, 5}, {7, 5}}, 1)}), 1U) << "a hole, for one";
    EXPECT_EQ(keptOf({typed(LineType::Outline, {{5, 5}, {7, 5}}, 2)}), 1U);
}

TEST(Scraps, AreFoundFarOutsideThePicture) {
    EXPECT_EQ(keptOf({longCrease, typed(LineType::Crease, {{-1e300, 5}, {-1e300, 6}})}), 1U);
    EXPECT_EQ(keptOf({typed(LineType::Crease, {{-1e12, 5}, {1e12, 5}})}), 1U);
}

}  // namespace
}  // namespace inkedge::lines
