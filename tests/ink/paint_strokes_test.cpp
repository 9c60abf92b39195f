#include "ink/paint_strokes.h"

#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include "ink/ink_measures.h"

namespace inkedge::ink {
namespace {

using ink_measures::Line;
using testing::Each;
using testing::ElementsAre;

constexpr std::uint8_t outline = 0;  // styles, by the bits of LineType
constexpr std::uint8_t crease = 3;

PictureSettings pictureOf(Size size, double width) {
    PictureSettings settings;
    settings.size = size;
    settings.lineWidth = {width, false};
    return settings;
}

Stroke strokeOf(const Line& line, std::uint8_t pen = outline) { return {glm::vec2{line.a}, glm::vec2{line.b}, pen}; }

Image<double> inkOf(std::span<const Stroke> strokes, const PictureSettings& settings) {
    return ink_measures::inkOf(paintStrokes(strokes, settings));
}

// Thirty angles over the half turn, none of which favours the pixels' axes.
constexpr int angleCount = 30;
double angle(int i) { return glm::radians(i * 180.0 / angleCount + 0.7); }

Line lineThrough(glm::dvec2 middle, double direction, double length) {
    const glm::dvec2 half = 0.5 * length * glm::dvec2{std::cos(direction), std::sin(direction)};
    return {middle - half, middle + half};
}

TEST(PaintStrokes, coverPixelsAsTheExactBandDoes) {
    for (const double width : {0.5, 1.0, 2.0, 3.5, 8.0, 32.0}) {
        for (int i = 0; i < angleCount; ++i) {
            SCOPED_TRACE(testing::Message() << "width " << width << ", angle " << i);
            const Line line = lineThrough({60.0 + 0.037 * i, 60.0 - 0.021 * i}, angle(i), 100.0);
            const Stroke stroke = strokeOf(line);
            const Image<double> ink = inkOf({&stroke, 1}, pictureOf({120, 120}, width));
            // A stroke's ends: its cap, and the pixel that the cap's edge cuts.
            ink_measures::expectStraight(ink_measures::measure(ink, line, width, 0.5 * width + 1.5), width);
        }
    }
}

TEST(PaintStrokes, endInRoundCaps) {
    for (const double width : {2.0, 8.0, 32.0}) {
        const Line line = lineThrough({60.3, 59.8}, glm::radians(20.0), 40.0);
        const Stroke stroke = strokeOf(line);
        const Image<double> ink = inkOf({&stroke, 1}, pictureOf({120, 120}, width));
        const std::array lines{line};
        ink_measures::Difference cap;  // around the end by the cap's radius and the pixels that its edge cuts
        ink_measures::compareAround(ink, ink_measures::exactInk({120, 120}, lines, width), line.b, 0.5 * width + 1.5,
                                    cap);
        EXPECT_LE(cap.rms(), ink_measures::rmsLimit) << width;
        if (width < 8.0) continue;  // a pixel is too coarse to judge
        // A square cap would still be black where the round one's diagonal has left.
        const double corner = 0.5 * width * 0.95;
        EXPECT_LT(ink_measures::inkAt(ink, line.b + corner * (line.direction() + line.normal())), 0.2) << width;
        EXPECT_GT(ink_measures::inkAt(ink, line.b + (0.5 * width - 1.0) * line.direction()), 0.8) << width;
    }
}

TEST(PaintStrokes, ofNoLengthAreDots) {
    const Stroke stroke = strokeOf({{20.2, 20.6}, {20.2, 20.6}});
    const Image<double> ink = inkOf({&stroke, 1}, pictureOf({40, 40}, 10.0));
    double sum = 0.0;
    for (const double there : ink.pixels()) sum += there;
    EXPECT_NEAR(sum, std::numbers::pi * 25.0, 0.5);  // the disc's edge is 31 pixels long: 0.016 of each
}

TEST(PaintStrokes, ofOneColourJoinWithoutASeam) {
    // A part's cap is taken along its tangent, which may cover a hundredth more than the whole; and rounding to a byte.
    constexpr double seamLimit = 0.01 + 0.5 / 255.0;
    for (const double width : {1.0, 3.5, 8.0}) {
        const Line whole = lineThrough({60.1, 60.4}, glm::radians(23.0), 80.0);
        std::vector<Stroke> parts;  // as the tracer leaves them: about a pixel long, of two types, overlapping nowhere
        constexpr int count = 75;
        for (int i = 0; i < count; ++i) {
            const auto at = [&](int k) { return glm::mix(whole.a, whole.b, static_cast<double>(k) / count); };
            parts.push_back(strokeOf({at(i), at(i + 1)}, i < 30 ? outline : crease));
        }
        const Stroke stroke = strokeOf(whole);
        const Image<double> ink = inkOf(parts, pictureOf({120, 120}, width));
        const Image<double> once = inkOf({&stroke, 1}, pictureOf({120, 120}, width));
        for (std::size_t i = 0; i < ink.pixels().size(); ++i) {
            ASSERT_NEAR(ink.pixels()[i], once.pixels()[i], seamLimit) << width << ", pixel " << i;
        }
    }
}

TEST(PaintStrokes, drawnTwiceAreNoDarker) {
    const Stroke stroke = strokeOf(lineThrough({20, 20}, 0.5, 30));
    const std::array twice{stroke, stroke};
    const PictureSettings settings = pictureOf({40, 40}, 1.5);
    EXPECT_EQ(paintStrokes(twice, settings).pixels(), paintStrokes({&stroke, 1}, settings).pixels());
}

TEST(PaintStrokes, ofAnEarlierTypeCoverThoseOfALaterOneInAnyOrder) {
    PictureSettings settings = pictureOf({21, 21}, 5.0);
    settings.pens[outline].color = Color{255, 0, 0};
    settings.pens[crease].color = Color{0, 0, 255};
    const Stroke across = strokeOf({{0.0, 10.5}, {21.0, 10.5}}, outline);
    const Stroke down = strokeOf({{10.5, 0.0}, {10.5, 21.0}}, crease);
    const auto picture = paintStrokes(std::array{across, down}, settings);
    EXPECT_EQ(picture.pixels(), paintStrokes(std::array{down, across}, settings).pixels());
    ASSERT_EQ(picture.channels(), 3);
    const auto pixel = [&](int x, int y) {
        return std::array{picture.at(x, y, 0), picture.at(x, y, 1), picture.at(x, y, 2)};
    };
    EXPECT_THAT(pixel(10, 10), ElementsAre(255, 0, 0));
    EXPECT_THAT(pixel(2, 10), ElementsAre(255, 0, 0));
    EXPECT_THAT(pixel(10, 2), ElementsAre(0, 0, 255));
    EXPECT_THAT(pixel(2, 2), ElementsAre(255, 255, 255));
}

TEST(PaintStrokes, ofDifferentWidthsKeepTheirOwn) {
    PictureSettings settings = pictureOf({100, 60}, 2.0);
    settings.pens[crease].width = PictureLength{6.0, false};
    const Line thin{{10, 15.2}, {90, 17.1}};
    const Line thick{{10, 40.2}, {90, 42.1}};
    const Image<double> ink = inkOf(std::array{strokeOf(thin), strokeOf(thick, crease)}, settings);
    EXPECT_NEAR(ink_measures::measure(ink, thin, 2.0, 5.0).meanWidth, 2.0, ink_measures::widthLimit);
    EXPECT_NEAR(ink_measures::measure(ink, thick, 6.0, 5.0).meanWidth, 6.0, ink_measures::widthLimit);
}

TEST(PaintStrokes, onATransparentBackgroundPutTheirCoverageIntoAlphaOnly) {
    PictureSettings settings = pictureOf({40, 40}, 3.0);
    settings.lineColor = {200, 40, 10};
    const Stroke stroke = strokeOf(lineThrough({20.3, 20.1}, 0.4, 24));
    settings.background = Color{255, 255, 255};
    const auto opaque = paintStrokes({&stroke, 1}, settings);
    settings.background.reset();
    const auto clear = paintStrokes({&stroke, 1}, settings);
    ASSERT_EQ(clear.channels(), 4);
    int partly = 0;
    for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) {
            const int alpha = clear.at(x, y, 3);
            partly += alpha > 0 && alpha < 255 ? 1 : 0;
            if (alpha > 0) {  // straight alpha: no background mixed in
                ASSERT_EQ(clear.at(x, y, 0), 200);
                ASSERT_EQ(clear.at(x, y, 1), 40);
                ASSERT_EQ(clear.at(x, y, 2), 10);
            }
            // Laid over white it is the opaque picture, but for two roundings.
            ASSERT_NEAR(255.0 + (40.0 - 255.0) * alpha / 255.0, opaque.at(x, y, 1), 1.01);
        }
    }
    EXPECT_GT(partly, 40);
}

TEST(PaintStrokes, giveAGreyPictureWhereAllIsGrey) {
    PictureSettings settings = pictureOf({8, 8}, 1.0);
    const Stroke stroke = strokeOf({{0, 4.5}, {8, 4.5}});
    const auto picture = paintStrokes({&stroke, 1}, settings);
    EXPECT_EQ(picture.channels(), 1);
    EXPECT_EQ(picture.at(4, 4), 0);
    EXPECT_EQ(picture.at(4, 1), 255);
    settings.pens[crease].color = Color{1, 0, 0};
    EXPECT_EQ(paintStrokes({&stroke, 1}, settings).channels(), 3);
}

TEST(PaintStrokes, beyondThePictureDoNoHarm) {
    const std::array strokes{strokeOf({{-50, -60}, {-20, -30}}), strokeOf({{70, 5}, {300, 9}}),
                             strokeOf({{-9, 3.5}, {60, 3.5}})};
    const auto picture = paintStrokes(strokes, pictureOf({32, 8}, 1.0));
    for (int x = 0; x < 32; ++x) {
        EXPECT_EQ(picture.at(x, 3), 0) << "runs through";
        EXPECT_EQ(picture.at(x, 6), 255);
    }
    EXPECT_THAT(paintStrokes({}, pictureOf({5, 3}, 1.0)).pixels(), Each(255));
}

// Large pictures are painted some rows at a time.
TEST(PaintStrokes, isTheSameAnywhereInALargePicture) {
    constexpr Size large{8192, 1100};
    constexpr Size small{8192, 60};
    for (const int down : {0, 482, 500, 512, 994, 1010, 1040}) {  // whole pixels
        const auto y = static_cast<float>(down);
        const std::vector<Stroke> strokes{{{10.25F, y + 20.5F}, {8000.5F, y + 40.75F}, 0},
                                          {{4000.0F, y + 5.0F}, {4016.0F, y + 55.0F}, 1}};
        const std::vector<Stroke> here{{{10.25F, 20.5F}, {8000.5F, 40.75F}, 0}, {{4000.0F, 5.0F}, {4016.0F, 55.0F}, 1}};
        const Image<std::uint8_t> all = paintStrokes(strokes, pictureOf(large, 7.0));
        const Image<std::uint8_t> part = paintStrokes(here, pictureOf(small, 7.0));
        EXPECT_TRUE(std::equal(part.pixels().begin(), part.pixels().end(),
                               all.pixels().begin() + static_cast<std::ptrdiff_t>(down) * large.width))
            << down;
    }
}

}  // namespace
}  // namespace inkedge::ink
