#include "ink/brush.h"

#include <array>
#include <cmath>
#include <fstream>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "base/expect_error.h"
#include "base/temporary_folder.h"
#include "curves/curves.h"
#include "ink/ink_measures.h"
#include "ink/paint_strokes.h"
#include "ink/strokes_of.h"

namespace inkedge::ink {
namespace {

using curves::lineThrough;
using testing::Each;
using testing::HasSubstr;

constexpr Size size{200, 100};
constexpr double width = 8.0;

PictureSettings picture(double penWidth = width) {
    PictureSettings settings;
    settings.size = size;
    settings.lineWidth = {penWidth, false};
    return settings;
}

Brush brushOf(Size pixels, auto ink) {
    Brush brush{{pixels, 1}};
    for (int y = 0; y < pixels.height; ++y) {
        for (int x = 0; x < pixels.width; ++x) brush.ink.at(x, y) = ink(x, y);
    }
    return brush;
}
Brush even(std::uint8_t ink) {
    return brushOf({5, 3}, [&](int, int) { return ink; });
}

// Twice as long as high: 8 pixels of ink along the line, 8 without.
constexpr double period = 16.0;
Brush striped() {
    return brushOf({32, 16}, [](int x, int) { return x < 16 ? std::uint8_t{255} : std::uint8_t{0}; });
}
bool isInk(double way) { return std::fmod(way, period) < 0.5 * period; }
bool isAwayFromAnEdge(double way) {  // texture pixels and drawn ones blur it
    const double from = std::fmod(way, 0.5 * period);
    return from > 2.0 && from < 0.5 * period - 2.0;
}

std::vector<Stroke> strokesThrough(const std::vector<Line>& all, const PictureSettings& settings,
                                   const LineSettings& how = {}) {
    Lines lines;
    lines.lines = all;
    lines.size = settings.size;
    return strokesOf(lines, settings, how);
}

Image<double> inkOf(std::span<const Stroke> strokes, const PictureSettings& settings, const Brush& brush) {
    return ink_measures::inkOf(paintStrokes(strokes, settings, &brush));
}

void expectStripes(const Image<double>& ink, const std::vector<glm::dvec2>& points, double across) {
    double before = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double length = glm::distance(points[i - 1], points[i]);
        const glm::dvec2 direction = (points[i] - points[i - 1]) / length;
        const glm::dvec2 normal{-direction.y, direction.x};
        const double joint = std::abs(across) + 1.0;  // where another part of the line may be nearer
        for (double s = joint; s < length - joint; s += 0.5) {
            if (!isAwayFromAnEdge(before + s)) continue;
            const glm::dvec2 p = points[i - 1] + s * direction + across * normal;
            EXPECT_NEAR(ink_measures::inkAt(ink, p), isInk(before + s) ? 1.0 : 0.0, 0.01)
                << before + s << " along, " << across << " across";
        }
        before += length;
    }
}

TEST(Brush, laysStripesAtTheirArcLengthsAroundCorners) {
    const std::vector<glm::dvec2> points{{10, 20}, {65.5, 20}, {65.5, 61}, {110, 80}, {180, 30}};
    const auto strokes = strokesThrough({lineThrough(points)}, picture());
    ASSERT_EQ(strokes.size(), points.size() - 1);
    const Image<double> ink = inkOf(strokes, picture(), striped());
    for (const double across : {0.0, -2.5, 2.5}) expectStripes(ink, points, across);
}

// Caps of the parts must not fill the gaps of the texture.
TEST(Brush, drawsALineInManyPartsAsInOne) {
    const glm::dvec2 a{10.3, 20.2};
    const glm::dvec2 b{190.7, 71.9};
    const std::array whole{Stroke{glm::vec2{a}, glm::vec2{b}, 0}};
    std::vector<Stroke> parts;
    constexpr int count = 170;
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 from = glm::mix(a, b, i / double{count});
        const glm::dvec2 to = glm::mix(a, b, (i + 1) / double{count});
        parts.push_back(
            {glm::vec2{from}, glm::vec2{to}, 0, fullWidth, fullWidth, static_cast<float>(glm::distance(a, from))});
    }
    const Image<double> once = inkOf(whole, picture(), striped());
    const Image<double> ink = inkOf(parts, picture(), striped());
    // As without a brush: a part's cap may cover a hundredth more; and rounding to a byte.
    for (std::size_t i = 0; i < ink.pixels().size(); ++i) ASSERT_NEAR(ink.pixels()[i], once.pixels()[i], 0.015) << i;
    expectStripes(ink, {a, b}, 0.0);
}

TEST(Brush, ofFullInkIsNone) {
    const std::vector<Line> lines{lineThrough({{10, 20}, {65.5, 20}, {65.5, 61}, {110, 80}, {180, 30}}),
                                  curves::circle({60.3, 50.1}, 30.2, 60)};
    for (const double taper : {0.0, 25.0}) {
        LineSettings how;
        how.strokeTaper = taper;
        const auto strokes = strokesThrough(lines, picture(5.0), how);
        const Brush brush = even(255);
        const auto with = paintStrokes(strokes, picture(5.0), &brush);
        const auto without = paintStrokes(strokes, picture(5.0));
        for (std::size_t i = 0; i < with.pixels().size(); ++i)  // a rounding of the band's position is a level
            ASSERT_NEAR(with.pixels()[i], without.pixels()[i], 1) << taper << ", pixel " << i;
    }
}

TEST(Brush, ofNoInkPaintsNothing) {
    const auto strokes = strokesThrough({lineThrough({{10, 20}, {65, 20}, {65, 61}})}, picture());
    const Brush brush = even(0);
    EXPECT_THAT(paintStrokes(strokes, picture(), &brush).pixels(), Each(255));
}

TEST(Brush, ofHalfInkCoversHalf) {
    const auto strokes = strokesThrough({lineThrough({{10, 20}, {100, 20}})}, picture());
    const Image<double> ink = inkOf(strokes, picture(), even(51));
    EXPECT_NEAR(ink.at(50, 20), 0.2, 0.002);  // half a level
    EXPECT_NEAR(ink.at(50, 18), 0.2, 0.002);
}

TEST(Brush, liesAcrossTheStrokeWhateverItsWidth) {
    // Ink in the upper half, which is at the left of the way: above a line to the right.
    const Brush brush = brushOf({16, 16}, [](int, int y) { return y < 8 ? std::uint8_t{255} : std::uint8_t{0}; });
    LineSettings how;
    how.strokeTaper = 100.0;
    const auto strokes = strokesThrough({lineThrough({{20, 50}, {180, 50}})}, picture(20.0), how);
    const Image<double> ink = inkOf(strokes, picture(20.0), brush);
    for (const int x : {60, 99, 140}) {
        const double half = 0.5 * 20.0 * std::min(x + 0.5 - 20.0, 180.0 - x - 0.5) / 100.0;
        double above = 0.0;
        double below = 0.0;
        for (int y = 30; y < 50; ++y) above += ink.at(x, y);
        for (int y = 50; y < 70; ++y) below += ink.at(x, y);
        // The texture's edge is blurred over a sixteenth of the width; it lies between two pixels.
        EXPECT_NEAR(above, half, 0.3) << x;
        EXPECT_NEAR(below, 0.0, 0.3) << x;
    }
}

TEST(Brush, goesAWholeNumberOfTimesAroundAClosedLine) {
    // Around rectangles whose way is no multiple of the period: stripes are as long everywhere, across the start too.
    for (const double high : {33.0, 35.0, 37.0, 40.0, 43.0}) {
        const std::vector<glm::dvec2> corners{{50, 20}, {150, 20}, {150, 20 + high}, {50, 20 + high}};
        const double around = 2.0 * (100.0 + high);
        const auto strokes = strokesThrough({curves::closedThrough(corners)}, picture());
        const Image<double> ink = inkOf(strokes, picture(), striped());
        const double fitted = around / std::round(around / period);
        for (double s = 2.0; s < around - 2.0; s += 0.5) {
            const double scaled = s * period / fitted;
            if (!isAwayFromAnEdge(scaled)) continue;
            double before = 0.0;
            for (std::size_t i = 0; i < 4; ++i) {
                const glm::dvec2 from = corners[i];
                const glm::dvec2 to = corners[(i + 1) % 4];
                const double length = glm::distance(from, to);
                if (s > before + 1.0 && s < before + length - 1.0) {
                    EXPECT_NEAR(ink_measures::inkAt(ink, glm::mix(from, to, (s - before) / length)),
                                isInk(scaled) ? 1.0 : 0.0, 0.01)
                        << s << " of " << around;
                }
                before += length;
            }
        }
    }
    // Shorter than half a texture: once.
    const FittedBrush brush{striped(), 8.0};
    EXPECT_FLOAT_EQ(brush.stretchAround(4.0F), 4.0F);
    EXPECT_FLOAT_EQ(brush.stretchAround(40.0F), 1.2F);
    EXPECT_FLOAT_EQ(brush.stretchAround(0.0F), 1.0F);
}

TEST(Brush, goesOnIntoTheCapsOfALinesEnds) {
    const auto strokes = strokesThrough({lineThrough({{50, 50}, {135, 50}})}, picture(30.0));
    const Image<double> ink = inkOf(strokes, picture(30.0), striped());  // 30 pixels of ink, 30 without
    for (const int y : {46, 50, 54}) {
        EXPECT_NEAR(ink.at(40, y), 0.0, 0.01) << "9.5 before the first ink";
        EXPECT_NEAR(ink.at(55, y), 1.0, 0.01);
        EXPECT_NEAR(ink.at(132, y), 1.0, 0.01) << "22.5 into the second";
        EXPECT_NEAR(ink.at(145, y), 0.0, 0.01) << "5.5 behind it";
    }
}

TEST(Brush, givesTheLargerInkWhereLinesMeet) {
    const std::vector<Line> lines{lineThrough({{20, 50}, {180, 50}}), lineThrough({{100, 10}, {100, 90}})};
    const auto ink = [&](const std::vector<Line>& drawn) {
        return inkOf(strokesThrough(drawn, picture()), picture(), striped());
    };
    const Image<double> both = ink(lines);
    const Image<double> across = ink({lines[0]});
    const Image<double> down = ink({lines[1]});
    for (std::size_t i = 0; i < both.pixels().size(); ++i)
        ASSERT_EQ(both.pixels()[i], std::max(across.pixels()[i], down.pixels()[i])) << i;
}

TEST(Brush, isAveragedWhereItIsFinerThanPixels) {
    const Brush brush =
        brushOf({640, 512}, [](int x, int y) { return (x + y) % 2 == 0 ? std::uint8_t{255} : std::uint8_t{0}; });
    const auto strokes = strokesThrough({lineThrough({{10, 20.3}, {150, 63.1}})}, picture());
    const Image<double> ink = inkOf(strokes, picture(), brush);
    for (double s = 0.1; s < 0.9; s += 0.01)
        EXPECT_NEAR(ink_measures::inkAt(ink, glm::mix(glm::dvec2{10, 20.3}, glm::dvec2{150, 63.1}, s)), 0.5, 0.02);
}

TEST(Brush, runsOnThroughDashes) {
    LineSettings how;
    how.hidden = HiddenLines::Dashed;
    Line line = lineThrough({{10, 50}, {190, 50}});
    line.visible = false;
    const auto strokes = strokesThrough({line}, picture(), how);
    ASSERT_GT(strokes.size(), 3U);
    EXPECT_EQ(strokes[0].arc, 0.0F);
    for (const Stroke& stroke : strokes) EXPECT_NEAR(stroke.arc, stroke.from.x - 10.0F, 1e-3);
}

class ReadBrush : public testing::Test {
protected:
    std::string file(const std::string& name, const std::string& bytes) const {
        std::ofstream{folder_ / name, std::ios::binary} << bytes;
        return (folder_ / name).string();
    }
    TemporaryFolder folder_;
};

TEST_F(ReadBrush, takesDarkForInkAndClearForNone) {
    // 4 x 1, grey and alpha: black, white, black half clear, black clear.
    static constexpr unsigned char png[]{0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0x00, 0x00, 0x00, 0x0d, 0x49,
                                         0x48, 0x44, 0x52, 0x00, 0x00, 0x00, 0x04, 0x00, 0x00, 0x00, 0x01, 0x08, 0x04,
                                         0x00, 0x00, 0x00, 0x53, 0x35, 0xc7, 0x46, 0x00, 0x00, 0x00, 0x11, 0x49, 0x44,
                                         0x41, 0x54, 0x78, 0x9c, 0x63, 0x60, 0xf8, 0xff, 0xff, 0x3f, 0x43, 0x03, 0x03,
                                         0x03, 0x00, 0x13, 0x77, 0x03, 0x7e, 0x95, 0x5f, 0x97, 0xe5, 0x00, 0x00, 0x00,
                                         0x00, 0x49, 0x45, 0x4e, 0x44, 0xae, 0x42, 0x60, 0x82};
    const std::string bytes{reinterpret_cast<const char*>(png), sizeof png};
    const Brush brush = readBrush(file("brush.png", bytes), {});
    EXPECT_EQ(brush.ink.size(), (Size{4, 1}));
    EXPECT_THAT(brush.ink.pixels(), testing::ElementsAre(255, 0, 128, 0));
}

TEST_F(ReadBrush, refusesInOneLineWhatIsNoPng) {
    const std::string missing = (folder_ / "none.png").string();
    expectError(Error::Kind::Input, HasSubstr(missing + ": expected a file, found none"),
                [&] { (void)readBrush(missing, {}); });
    const std::string text = file("text.png", "no picture");
    expectError(Error::Kind::Input, HasSubstr(text + ": expected a PNG picture, found other text"),
                [&] { (void)readBrush(text, {}); });
    const std::string cut = file("cut.png", std::string{"\x89PNG\r\n\x1a\n", 8} + "IHDR");
    expectError(Error::Kind::Input, HasSubstr(cut + ": expected a PNG picture, found: "),
                [&] { (void)readBrush(cut, {}); });
}

}  // namespace
}  // namespace inkedge::ink
