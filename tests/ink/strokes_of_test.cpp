#include "ink/strokes_of.h"

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include "curves/curves.h"
#include "ink/paint_strokes.h"

namespace inkedge::ink {
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
    EXPECT_EQ(strokes[1].pen, crease);
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
    settings.lines = standardLineTypes - LineType::Marked;
    EXPECT_TRUE(strokesOf(linesOf({line}), settings, {}).empty());
    settings.lines = LineType::Marked;
    EXPECT_EQ(strokesOf(linesOf({line}), settings, {}).size(), 1U);
}

TEST(StrokesOf, fadeWithTheStrengthOfLinesOfForm) {
    Line line = lineThrough({{10, 10}, {30, 10}, {50, 10}});
    line.type = LineType::Valley;
    line.points[0].strength = 0.0;
    line.points[1].strength = 0.5;
    LineSettings settings;
    PictureSettings every = picture(2.0);
    every.lines = allLineTypes;
    EXPECT_EQ(strokesOf(linesOf({line}), every, settings).at(0).widthFrom, fullWidth);
    settings.strokeWidth = StrokeWidth::Strength;
    const auto strokes = strokesOf(linesOf({line}), every, settings);
    ASSERT_EQ(strokes.size(), 2U) << "a straight line keeps the points between which it fades";
    EXPECT_EQ(strokes[0].widthFrom, 0);
    EXPECT_EQ(strokes[0].widthTo, fullWidth / 2);
    EXPECT_EQ(strokes[1].widthTo, fullWidth);
    line.type = LineType::Crease;
    EXPECT_EQ(strokesOf(linesOf({line}), picture(2.0), settings).at(0).widthFrom, fullWidth);
}

TEST(StrokesOf, drawHiddenLinesAsTheSettingSays) {
    const Lines lines = linesOf({hidden(lineThrough({{10, 10}, {110, 10}}))});
    LineSettings settings;
    EXPECT_TRUE(strokesOf(lines, picture(2.0), settings).empty());
    settings.hidden = HiddenLines::Solid;
    const auto solid = strokesOf(lines, picture(2.0), settings);
    ASSERT_EQ(solid.size(), 1U);
    EXPECT_EQ(solid[0].pen, outline + lineTypeCount);
    settings.hidden = HiddenLines::Dashed;
    const auto dashed =
        strokesOf(lines, picture(2.0), settings);  // 6 on, 4 off in pens 1 pixel wide: ten whole periods
    ASSERT_EQ(dashed.size(), 10U);
    EXPECT_NEAR(lengthOf(dashed), 60.0, 1e-3);
    EXPECT_EQ(dashed[0].from, glm::vec2(10, 10));
    EXPECT_NEAR(dashed[9].from.x, 100.0, 1e-4);
    EXPECT_NEAR(dashed[9].to.x, 106.0, 1e-4);
}

TEST(StrokesOf, dashesAreThoseOfTheHiddenPen) {
    Lines lines;
    lines.size = {200, 100};
    Line line = curves::lineThrough({{10, 10}, {110, 10}});
    line.type = LineType::Crease;
    line.visible = false;
    lines.lines = {line};
    LineSettings settings;
    settings.hidden = HiddenLines::Dashed;
    PictureSettings wanted = picture(2.0);
    wanted.hiddenPen = {PictureLength{3.0}, Color{9, 9, 9}, DashPattern{PictureLength{15.0}, PictureLength{10.0}}};
    const auto dashed = strokesOf(lines, wanted, settings);
    ASSERT_EQ(dashed.size(), 4U);
    EXPECT_NEAR(lengthOf(dashed), 60.0, 1e-3);
    EXPECT_EQ(dashed[1].from, glm::vec2(35, 10));
    const settings::Pen pen = settings::pens(wanted)[dashed[0].pen];
    EXPECT_EQ(pen.width, 3.0);
    EXPECT_EQ(pen.color, (Color{9, 9, 9}));
    wanted.dpi = 254.0;  // ten pixels a millimetre
    wanted.hiddenPen.dash = DashPattern{{1.5, true}, {1.0, true}};
    EXPECT_DOUBLE_EQ(settings::pens(wanted)[dashed[0].pen].dash, 15.0);
    EXPECT_DOUBLE_EQ(settings::pens(wanted)[dashed[0].pen].gap, 10.0);
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
    settings.pens[outline].color = Color{255, 0, 0};
    settings.pens[crease].color = Color{0, 0, 255};
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

// A line at this depth before a camera at the origin, in the picture at this height.
Line atDepth(double from, double to, double y) {
    Line line = lineThrough({{10, y}, {110, y}});
    line.points[0].position = {0, 0, -from};
    line.points[1].position = {0, 0, -to};
    return line;
}

TEST(StrokesOf, areWiderWhereTheLineIsNearer) {
    LineSettings settings;
    settings.strokeWidth = StrokeWidth::Depth;
    const auto strokes = strokesOf(linesOf({atDepth(1.0, 4.0, 20), atDepth(1.6, 1.6, 40)}), picture(8.0), settings);
    ASSERT_EQ(strokes.size(), 2U);
    EXPECT_EQ(strokes[0].widthFrom, fullWidth * 3 / 2);
    EXPECT_EQ(strokes[0].widthTo, fullWidth / 2);
    // In perspective half-way between in the picture: 1/1.6 = (1/1 + 1/4) / 2.
    EXPECT_EQ(strokes[1].widthFrom, fullWidth);
    const auto ink = paintStrokes(strokes, picture(8.0));
    const auto thickness = [&](int x, int middle) {
        double sum = 0.0;
        for (int y = middle - 10; y < middle + 10; ++y) sum += (255 - ink.at(x, y)) / 255.0;
        return sum;
    };
    // The band is as wide as at the pixel's centre, and bytes are rounded.
    EXPECT_NEAR(thickness(20, 20), 12.0 - 8.0 * 0.105, 0.1);
    EXPECT_NEAR(thickness(90, 20), 12.0 - 8.0 * 0.805, 0.1);
    EXPECT_NEAR(thickness(60, 40), 8.0, 0.02);
}

TEST(StrokesOf, areWiderWhereTheLineIsStraighter) {
    LineSettings settings;
    settings.strokeWidth = StrokeWidth::Curvature;
    const auto widest = [&](const Line& line) {
        std::uint8_t largest = 0;
        for (const Stroke& stroke : strokesOf(linesOf({line}), picture(2.0), settings)) {
            largest = std::max(largest, stroke.widthFrom);
        }
        return largest;
    };
    EXPECT_EQ(widest(lineThrough({{10, 10}, {150, 40}})), fullWidth * 3 / 2);
    // Of radius 15: half-way; 40: 40/55 of the way. Chords of a simplified circle bend by up to a tenth more or less.
    EXPECT_NEAR(widest(curves::circle({50, 50}, 15, 200)), fullWidth, 8);
    EXPECT_NEAR(widest(curves::circle({50, 50}, 40, 400)), fullWidth * (0.5 + 40.0 / 55.0), 10);
}

TEST(StrokesOf, runOutAtTheEndsOfOpenLinesOnly) {
    LineSettings settings;
    settings.strokeTaper = 20.0;
    const auto strokes = strokesOf(linesOf({lineThrough({{10, 50}, {110, 50}})}), picture(4.0), settings);
    ASSERT_EQ(strokes.size(), 3U);
    EXPECT_EQ(strokes[0].widthFrom, 0);
    EXPECT_EQ(strokes[0].widthTo, fullWidth);
    EXPECT_EQ(strokes[1].from, glm::vec2(30, 50));
    EXPECT_EQ(strokes[1].to, glm::vec2(90, 50));
    EXPECT_EQ(strokes[2].widthFrom, fullWidth);
    EXPECT_EQ(strokes[2].widthTo, 0);
    const auto cut = strokesOf(linesOf({lineThrough({{150, 50}, {900, 50}})}), picture(4.0), settings);
    EXPECT_EQ(cut.front().widthFrom, 0);
    EXPECT_EQ(cut.back().widthTo, fullWidth) << "where the picture cuts it, a line goes on";
    const auto brief = strokesOf(linesOf({lineThrough({{10, 50}, {30, 50}})}), picture(4.0), settings);
    ASSERT_EQ(brief.size(), 2U);
    EXPECT_EQ(brief[0].widthTo, fullWidth / 2);
    for (const Stroke& stroke : strokesOf(linesOf({curves::circle({50, 50}, 30, 60)}), picture(4.0), settings)) {
        EXPECT_EQ(stroke.widthFrom, fullWidth);
    }
    EXPECT_EQ(strokesOf(linesOf({lineThrough({{5, 5}, {5, 5}})}), picture(4.0), settings).size(), 1U);
}

TEST(StrokesOf, keepTheirWidthWhereAnotherLineGoesOn) {
    LineSettings settings;
    settings.strokeTaper = 20.0;
    Line second{.type = LineType::Crease, .points = {{{60, 50}, {1, 60, 50}}, {{110, 50}, {2, 110, 50}}}};
    const auto strokes = strokesOf(linesOf({lineThrough({{10, 50}, {60, 50}}), second}), picture(4.0), settings);
    ASSERT_EQ(strokes.size(), 4U);
    EXPECT_EQ(strokes[0].widthFrom, 0);
    EXPECT_EQ(strokes[1].widthTo, fullWidth);
    EXPECT_EQ(strokes[2].widthFrom, fullWidth);
    EXPECT_EQ(strokes[3].widthTo, 0);
}

}  // namespace
}  // namespace inkedge::ink
