#include "ink/strokes_of.h"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "curves/curves.h"

namespace inkedge {
namespace {

using curves::closedThrough;
using curves::lineThrough;

Lines linesOf(std::vector<Line> all) {
    Lines lines;
    lines.lines = std::move(all);
    lines.size = {200, 100};
    return lines;
}

PictureSettings picture(double width) {
    PictureSettings settings;
    settings.size = {200, 100};
    settings.lineWidth = {width, false};
    return settings;
}

double lengthOf(const std::vector<Stroke>& strokes) {
    double length = 0.0;
    for (const Stroke& stroke : strokes) length += glm::distance(stroke.from, stroke.to);
    return length;
}

Line hidden(Line line) {
    line.visible = false;
    return line;
}

constexpr std::uint8_t outline = 0;
constexpr std::uint8_t crease = 3;

TEST(StrokesOf, runThroughThePointsOfALine) {
    Line line = lineThrough({{10, 10}, {50, 10}, {50, 40}});
    line.type = LineType::Crease;
    const auto strokes = strokesOf(linesOf({line}), picture(2.0), {});
    ASSERT_EQ(strokes.size(), 2U);
    EXPECT_EQ(strokes[0].from, glm::vec2(10, 10));
    EXPECT_EQ(strokes[0].to, glm::vec2(50, 10));
    EXPECT_EQ(strokes[1].to, glm::vec2(50, 40));
    EXPECT_EQ(strokes[1].style, crease);
}

TEST(StrokesOf, joinAClosedLinesLastPointToItsFirst) {
    const auto strokes = strokesOf(linesOf({closedThrough({{10, 10}, {50, 10}, {50, 40}})}), picture(2.0), {});
    ASSERT_EQ(strokes.size(), 3U);
    EXPECT_EQ(strokes[2].from, glm::vec2(50, 40));
    EXPECT_EQ(strokes[2].to, glm::vec2(10, 10));
}

TEST(StrokesOf, leaveOutTypesThatAreNotDrawn) {
    Line line = lineThrough({{10, 10}, {50, 10}});
    line.type = LineType::Marked;
    PictureSettings settings = picture(2.0);
    settings.lines = allLineTypes & ~static_cast<unsigned>(LineType::Marked);
    EXPECT_TRUE(strokesOf(linesOf({line}), settings, {}).empty());
    settings.lines = static_cast<std::uint8_t>(LineType::Marked);
    EXPECT_EQ(strokesOf(linesOf({line}), settings, {}).size(), 1U);
}

TEST(StrokesOf, drawHiddenLinesAsTheSettingSays) {
    const Lines lines = linesOf({hidden(lineThrough({{10, 10}, {110, 10}}))});
    LineSettings settings;
    EXPECT_TRUE(strokesOf(lines, picture(2.0), settings).empty());
    settings.hidden = HiddenLines::Solid;
    const auto solid = strokesOf(lines, picture(2.0), settings);
    ASSERT_EQ(solid.size(), 1U);
    EXPECT_EQ(solid[0].style, outline + lineTypeCount);
    settings.hidden = HiddenLines::Dashed;
    const auto dashed =
        strokesOf(lines, picture(2.0), settings);  // 6 on, 4 off in pens 1 pixel wide: ten whole periods
    ASSERT_EQ(dashed.size(), 10U);
    EXPECT_NEAR(lengthOf(dashed), 60.0, 1e-3);
    EXPECT_EQ(dashed[0].from, glm::vec2(10, 10));
    EXPECT_NEAR(dashed[9].from.x, 100.0, 1e-4);
    EXPECT_NEAR(dashed[9].to.x, 106.0, 1e-4);
}

TEST(StrokesOf, leadDashesAroundCorners) {
    LineSettings settings;
    settings.hidden = HiddenLines::Dashed;
    const Lines lines = linesOf({hidden(lineThrough({{10, 10}, {14, 10}, {14, 22}}))});
    const auto dashed = strokesOf(lines, picture(2.0), settings);
    // 16 pixels along: a dash to 6, the corner at 4 within it, a gap to 10, a dash to the end.
    ASSERT_EQ(dashed.size(), 3U);
    EXPECT_EQ(dashed[0].to, glm::vec2(14, 10));
    EXPECT_EQ(dashed[1].from, glm::vec2(14, 10));
    EXPECT_EQ(dashed[1].to, glm::vec2(14, 12));
    EXPECT_EQ(dashed[2].from, glm::vec2(14, 16));
    EXPECT_EQ(dashed[2].to, glm::vec2(14, 22));
}

TEST(StrokesOf, areCutHalfAWidthBeyondThePicture) {
    const auto strokes = strokesOf(linesOf({lineThrough({{-1e12, 50}, {1e12, 50}})}), picture(6.0), {});
    ASSERT_EQ(strokes.size(), 1U);
    EXPECT_NEAR(strokes[0].from.x, -3.0, 1e-2);
    EXPECT_NEAR(strokes[0].to.x, 203.0, 1e-2);
    EXPECT_TRUE(strokesOf(linesOf({lineThrough({{0, -3.1}, {200, -3.1}})}), picture(6.0), {}).empty());
    EXPECT_FALSE(strokesOf(linesOf({lineThrough({{0, -2.9}, {200, -2.9}})}), picture(6.0), {}).empty());
}

TEST(StrokesOf, ofALineWithoutLengthAreADot) {
    EXPECT_EQ(strokesOf(linesOf({lineThrough({{5, 5}, {5, 5}})}), picture(6.0), {}).size(), 1U);
    LineSettings settings;
    settings.hidden = HiddenLines::Dashed;
    EXPECT_EQ(strokesOf(linesOf({hidden(lineThrough({{5, 5}, {5, 5}}))}), picture(6.0), settings).size(), 1U);
}

TEST(StrokesOf, seenCoverHiddenOnesOfAnEarlierType) {
    PictureSettings settings = picture(6.0);
    settings.lineStyles[outline].color = Color{255, 0, 0};
    settings.lineStyles[crease].color = Color{0, 0, 255};
    LineSettings solid;
    solid.hidden = HiddenLines::Solid;
    Line seen = lineThrough({{50, 0}, {50, 100}});
    seen.type = LineType::Crease;
    const auto strokes = strokesOf(linesOf({hidden(lineThrough({{0, 50}, {200, 50}})), seen}), settings, solid);
    const auto ink = paintStrokes(strokes, settings);
    EXPECT_EQ(ink.at(50, 50, 0), 0);
    EXPECT_EQ(ink.at(50, 50, 2), 255);
    EXPECT_EQ(ink.at(100, 50, 0), 255);
    EXPECT_EQ(ink.at(100, 50, 2), 0);
    EXPECT_EQ(ink.at(100, 52, 2), 255) << "white: hidden lines have half the width";
    EXPECT_EQ(ink.at(52, 20, 0), 0) << "the seen one has its whole width";
}

}  // namespace
}  // namespace inkedge
