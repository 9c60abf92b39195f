// Lines that are drawn as ink are found again in the picture.
#include <inkedge/compare_lines.h>

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

namespace inkedge {
namespace {

using testing::IsEmpty;

constexpr Size size{160, 120};
constexpr float white = 1.0F;

double distanceTo(const ComparedLine& line, glm::dvec2 p) {
    double best = INFINITY;
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (line.closed ? 0 : 1) < count; ++i) {
        const glm::dvec2 a = line.points[i];
        const glm::dvec2 along = line.points[(i + 1) % count] - a;
        const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
        best = std::min(best, glm::distance(p, a + t * along));
    }
    return best;
}

struct Ink {
    ComparedLine line;
    double width = 1.5;
    float value = 0.0F;
};

// Coverage by 5 x 5 samples a pixel.
Image<float> paint(const std::vector<Ink>& inks, const std::function<float(int x, int y)>& paper) {
    Image<float> picture{size, 1};
    constexpr int samples = 5;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            float value = paper(x, y);
            for (const Ink& ink : inks) {
                if (distanceTo(ink.line, {x + 0.5, y + 0.5}) > ink.width + 1.0) continue;
                int covered = 0;
                for (int k = 0; k < samples * samples; ++k) {
                    const glm::dvec2 at{x + (k % samples + 0.5) / samples, y + (k / samples + 0.5) / samples};
                    covered += distanceTo(ink.line, at) <= 0.5 * ink.width ? 1 : 0;
                }
                const float share = static_cast<float>(covered) / (samples * samples);
                value += share * (ink.value - value);
            }
            picture(x, y) = value;
        }
    }
    return picture;
}

float onWhite(int, int) { return white; }

ComparedLine polyline(std::vector<glm::dvec2> points, bool closed = false) {
    return {{}, true, closed, 0, std::move(points)};
}

ComparedLine circle(glm::dvec2 centre, double radius) {
    ComparedLine line = polyline({}, true);
    for (int i = 0; i < 96; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 96;
        line.points.push_back(centre + radius * glm::dvec2{std::cos(angle), std::sin(angle)});
    }
    return line;
}

std::vector<Ink> drawing(double width) {
    return {{polyline({{20.3, 15}, {140, 15}, {140, 105.6}, {20.3, 105.6}}, true), width},
            {circle({60.2, 60.7}, 20), width},
            {polyline({{95, 30}, {130.5, 95}}), width},
            {polyline({{95, 95}, {130.5, 30}}), width}};
}

ComparedLines expected(const std::vector<Ink>& inks) {
    ComparedLines all{.lines = {}, .size = size, .objects = {}};
    for (const Ink& ink : inks) all.lines.push_back(ink.line);
    return all;
}

TEST(CentreLines, AreWhereInkWasDrawn) {
    for (const double width : {0.75, 1.5, 3.0, 5.0}) {
        const std::vector<Ink> inks = drawing(width);
        const ComparedLines found = comparedLines(paint(inks, onWhite));
        // Half a pixel, but where two lines cross: there the middle of the ink is that of both.
        const LinesComparison compared = compareLines(expected(inks), found, {.distance = 0.5, .speck = 4.0 + width});
        EXPECT_THAT(compared.changes, IsEmpty()) << width << '\n' << comparisonText(compared);
        EXPECT_NEAR(compared.lengthAfter, compared.lengthBefore, 0.03 * compared.lengthBefore) << width;
    }
}

TEST(CentreLines, LieOnAnyFill) {
    const auto fill = [](int x, int y) { return x > 40 ? 0.5F + 0.002F * static_cast<float>(y) : white; };
    const std::vector<Ink> dark{{polyline({{20, 30.2}, {140, 30.2}}), 2.0}, {polyline({{41, 0}, {41, 119}}), 2.0}};
    LinesComparison compared = compareLines(expected(dark), comparedLines(paint(dark, fill)));
    EXPECT_THAT(compared.changes, IsEmpty()) << comparisonText(compared);

    const auto blue = [](int, int) { return 0.2F; };
    const std::vector<Ink> light{{circle({80, 60}, 40), 1.5, 1.0F}};
    compared = compareLines(expected(light), comparedLines(paint(light, blue)));
    EXPECT_THAT(compared.changes, IsEmpty()) << comparisonText(compared);
}

TEST(CentreLines, GoOnWhereOthersCrossThem) {
    const std::vector<Ink> inks{{polyline({{20, 50}, {140, 70}}), 2.0}, {polyline({{70, 10}, {90, 110}}), 2.0}};
    const ComparedLines found = comparedLines(paint(inks, onWhite));
    std::size_t whole = 0;
    for (const ComparedLine& line : found.lines)
        whole += glm::distance(line.points.front(), line.points.back()) > 95.0 ? 1U : 0U;
    EXPECT_EQ(whole, 2U) << found.lines.size();
}

TEST(CentreLines, ReachTheEndsOfLinesTwoPixelsWide) {
    const std::vector<Ink> inks{{polyline({{30, 10}, {30, 90}}), 2.0}, {polyline({{50, 100}, {130, 100}}), 2.0}};
    const LinesComparison compared = compareLines(expected(inks), comparedLines(paint(inks, onWhite)));
    EXPECT_THAT(compared.changes, IsEmpty()) << comparisonText(compared);
    EXPECT_NEAR(compared.lengthAfter, 160.0, 6.0);
}

TEST(CentreLines, AreNotMovedByLevels) {
    const std::vector<Ink> inks = drawing(1.5);
    Image<float> noisy = paint(inks, onWhite);
    int i = 0;
    for (float& value : noisy.mutablePixels()) value += static_cast<float>(++i * 7919 % 13 - 6) / 255.0F;
    const LinesComparison compared = compareLines(comparedLines(paint(inks, onWhite)), comparedLines(noisy));
    EXPECT_THAT(compared.changes, IsEmpty()) << comparisonText(compared);
    EXPECT_EQ(compared.specks, 0);
}

TEST(CentreLines, ShowAHoleThatMoved) {
    std::vector<Ink> moved = drawing(1.5);
    moved[1].line = circle({60.2, 62.7}, 20);
    const LinesComparison compared =
        compareLines(comparedLines(paint(drawing(1.5), onWhite)), comparedLines(paint(moved, onWhite)));
    ASSERT_EQ(compared.changes.size(), 1) << comparisonText(compared);
    EXPECT_EQ(compared.changes[0].kind, LineChangeKind::Moved);
    ASSERT_TRUE(compared.changes[0].way) << comparisonText(compared);
    EXPECT_NEAR(compared.changes[0].way->x, 0.0, 0.1);
    EXPECT_NEAR(compared.changes[0].way->y, 2.0, 0.1);
    EXPECT_NEAR(compared.changes[0].length, 125.7, 2.0);
}

TEST(CentreLines, OfNothingAreNone) {
    EXPECT_THAT(comparedLines(paint({}, onWhite)).lines, IsEmpty());
    EXPECT_THAT(comparedLines(paint({}, [](int x, int) { return 0.003F * static_cast<float>(x); })).lines, IsEmpty());
    EXPECT_THAT(comparedLines(Image<float>{}).lines, IsEmpty());
}

TEST(CentreLines, GoToThePicturesEdges) {
    const std::vector<Ink> inks{{polyline({{0, 40.5}, {160, 40.5}}), 1.5}, {polyline({{0.5, 0}, {0.5, 120}}), 1.0}};
    const LinesComparison compared = compareLines(expected(inks), comparedLines(paint(inks, onWhite)));
    EXPECT_THAT(compared.changes, IsEmpty()) << comparisonText(compared);
}

}  // namespace
}  // namespace inkedge
