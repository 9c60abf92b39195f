#include "curves/clip.h"

#include <gmock/gmock.h>

#include "curves/curves.h"

namespace inkedge::curves {
namespace {

using namespace curves;
using glm::dvec2;
using testing::ElementsAre;

constexpr dvec2 low{0.0};
constexpr dvec2 high{100.0};

std::vector<dvec2> pixels(const Line& line) {
    std::vector<dvec2> all;
    for (const LinePoint& p : line.points) all.push_back(p.pixel);
    return all;
}

TEST(Clip, leavesWhatLiesInside) {
    const Line line = lineThrough({{0, 0}, {50, 60}, {100, 100}});
    const auto parts = clip(line, low, high);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(pixels(parts[0]), pixels(line));
    const auto ring = clip(circle({50, 50}, 40, 30), low, high);
    ASSERT_EQ(ring.size(), 1U);
    EXPECT_TRUE(ring[0].closed);
}

TEST(Clip, cutsAtTheSides) {
    Line line = lineThrough({{-50, 50}, {150, 50}, {150, 20}, {-50, 20}});
    line.type = LineType::Crease;
    line.object = 3;
    const auto parts = clip(line, low, high);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_THAT(pixels(parts[0]), ElementsAre(dvec2{0, 50}, dvec2{100, 50}));
    EXPECT_THAT(pixels(parts[1]), ElementsAre(dvec2{100, 20}, dvec2{0, 20}));
    EXPECT_EQ(parts[1].type, LineType::Crease);
    EXPECT_EQ(parts[1].object, 3U);
    EXPECT_NEAR(parts[0].points[0].position.x, 0.25, 1e-12) << "a quarter of the way from point 0 to point 1";
}

TEST(Clip, dropsWhatLiesOutside) {
    EXPECT_TRUE(clip(lineThrough({{-5, 0}, {-5, 90}}), low, high).empty());
    EXPECT_TRUE(clip(lineThrough({{-50, 40}, {40, -60}}), low, high).empty()) << "past a corner";
    EXPECT_TRUE(clip(lineThrough({{50, 50}}), low, high).empty()) << "no line";
    const double none = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(clip(lineThrough({{none, 50}, {50, none}}), low, high).empty());
}

TEST(Clip, joinsTheEndsOfAClosedLineThatStartsInside) {
    // A square whose right half lies beyond the side; it starts within.
    const auto parts = clip(closedThrough({{50, 40}, {150, 40}, {150, 60}, {50, 60}}), low, high);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_FALSE(parts[0].closed);
    EXPECT_THAT(pixels(parts[0]), ElementsAre(dvec2{100, 60}, dvec2{50, 60}, dvec2{50, 40}, dvec2{100, 40}));
}

TEST(Clip, keepsExactlyWhatIsInsideOfWindingLines) {
    for (unsigned seed = 1; seed < 6; ++seed) {
        const Line line = winding(300, 0.5, seed);
        const dvec2 from{100, 160};
        const dvec2 to{300, 220};
        double expected = 0.0;  // length inside, by samples
        const auto samples = sampled(outlineOf(line), 0.01);
        for (std::size_t i = 1; i < samples.size(); ++i) {
            const dvec2 p = 0.5 * (samples[i - 1] + samples[i]);
            if (p.x > from.x && p.x < to.x && p.y > from.y && p.y < to.y)
                expected += glm::distance(samples[i - 1], samples[i]);
        }
        double length = 0.0;
        for (const Line& part : clip(line, from, to)) {
            for (std::size_t i = 1; i < part.points.size(); ++i) {
                length += glm::distance(part.points[i - 1].pixel, part.points[i].pixel);
            }
        }
        EXPECT_NEAR(length, expected, 0.5) << "some twenty cuts, each between samples 0.01 apart";
    }
}

}  // namespace
}  // namespace inkedge::curves
