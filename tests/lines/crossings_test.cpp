#include "lines/see/crossings.h"

#include <random>

#include <gmock/gmock.h>

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

const Size size{400, 300};

// A pixel a unit; the larger z, the nearer.
Screen flat() { return {views::orthographic({0, 0, 100}, 300.0), glm::dvec3{0.0}, size}; }

Segment segment(glm::dvec3 a, glm::dvec3 b) {
    Segment s;
    s.ends = {a, b};
    return s;
}

struct Crossed {
    std::vector<Segment> segments;
    std::vector<ScreenSegment> projected;
    std::vector<Crossing> crossings;
    explicit Crossed(std::vector<Segment> all, const Screen& screen = flat())
        : segments{std::move(all)},
          projected{project(segments, screen)},
          crossings{findCrossings(segments, projected, screen)} {}
};

TEST(Crossings, AreWhereAContourPassesBefore) {
    const Crossed c{{segment({-10, 0, 0}, {30, 0, 0}), segment({0, -10, 5}, {0, 10, 5})}};
    ASSERT_THAT(c.crossings, SizeIs(1));
    EXPECT_EQ(c.crossings[0].segment, 0U);  // not 1: it passes before
    EXPECT_DOUBLE_EQ(c.crossings[0].at, 0.25);
}

TEST(Crossings, NeedADifferenceInDepth) {
    // On one surface: nearer by less than a twentieth of a pixel.
    EXPECT_THAT((Crossed{{segment({-10, 0, 0}, {30, 0, 0}), segment({0, -10, 0.049}, {0, 10, 0.049})}}.crossings),
                IsEmpty());
    EXPECT_THAT((Crossed{{segment({-10, 0, 0}, {30, 0, 0}), segment({0, -10, 0.051}, {0, 10, 0.051})}}.crossings),
                SizeIs(1));
    // A smooth contour may lie that much deeper.
    auto smooth = segment({-10, 0, 0}, {30, 0, 0});
    smooth.slack = 1.0;
    EXPECT_THAT((Crossed{{smooth, segment({0, -10, 1.04}, {0, 10, 1.04})}}.crossings), IsEmpty());
    EXPECT_THAT((Crossed{{smooth, segment({0, -10, 1.06}, {0, 10, 1.06})}}.crossings), SizeIs(1));
}

TEST(Crossings, GiveASmoothContourItsSlackOnItsOwnPartOnly) {
    const Mesh one = scenes::cube(1.0);
    const Scene scene = scenes::sceneOf({{one, glm::dmat4{1.0}}, {one, scenes::translation({3, 0, 0})}});
    const SurfaceComponents parts{scene, {}};
    auto smooth = segment({-10, 0, 0}, {30, 0, 0});
    smooth.slack = 1.0;
    smooth.faces[0] = {0, 2};
    auto before = segment({0, -10, 0.5}, {0, 10, 0.5});
    for (const std::uint32_t instance : {0U, 1U}) {
        before.faces[0] = {instance, 3};
        std::vector<Segment> both{smooth, before};
        const auto projected = project(both, flat());
        EXPECT_THAT(findCrossings(both, projected, flat(), &parts), SizeIs(instance)) << instance;
    }
}

TEST(Crossings, AreNotWhereSegmentsMeet) {
    auto a = segment({0, 0, 0}, {30, 0, 0});
    auto b = segment({10, -5, 5}, {10, 5, 5});
    a.keys = {1, 2};
    b.keys = {2, 3};
    EXPECT_THAT((Crossed{{a, b}}.crossings), IsEmpty());
    a.keys = b.keys = {noKey, noKey};
    EXPECT_THAT((Crossed{{a, b}}.crossings), SizeIs(1));
}

TEST(Crossings, AreOfWhatIsDrawnWithWhatOccludes) {
    auto back = segment({-10, 0, 0}, {30, 0, 0});
    auto front = segment({0, -10, 5}, {0, 10, 5});
    front.drawn = false;
    EXPECT_THAT((Crossed{{back, front}}.crossings), SizeIs(1));
    back.drawn = false;
    EXPECT_THAT((Crossed{{back, front}}.crossings), IsEmpty());
    back.drawn = true;
    front.occludes = false;
    EXPECT_THAT((Crossed{{back, front}}.crossings), IsEmpty());
}

TEST(Crossings, UseTheDepthOfThePictureNotOfSpace) {
    // In the picture's middle the slanted segment is seen at the harmonic mean of its depths, 1.6, not at 2.5.
    Camera camera = views::perspective({0, 0, 0}, {0, 0, -1}, 90.0);
    const Screen screen{camera, glm::dvec3{0.0}, size};
    const auto slanted = segment({-0.5, 0, -1}, {2, 0, -4});
    for (const double depth : {1.55, 1.65}) {
        const Crossed c{{slanted, segment({0, -1, -depth}, {0, 1, -depth})}, screen};
        ASSERT_THAT(c.crossings, SizeIs(1)) << depth;
        EXPECT_EQ(c.crossings[0].segment, depth < 1.6 ? 0U : 1U);
        EXPECT_NEAR(c.crossings[0].at, 0.5, 1e-12);
    }
}

TEST(Crossings, AreThoseThatEveryPairHas) {
    std::mt19937 random{7};
    std::uniform_real_distribution<double> x{-260.0, 260.0};  // off the picture too
    std::uniform_real_distribution<double> y{-200.0, 200.0};
    std::uniform_real_distribution<double> z{-1.0, 1.0};
    std::uniform_real_distribution<double> step{-40.0, 40.0};
    std::vector<Segment> all;
    for (int i = 0; i < 900; ++i) {
        const glm::dvec3 a{x(random), y(random), z(random)};
        const bool isLong = i % 50 == 0;
        const glm::dvec3 b = isLong ? glm::dvec3{x(random), y(random), z(random)}
                                    : a + glm::dvec3{step(random), i % 7 == 0 ? 0.0 : step(random), 0.1 * z(random)};
        all.push_back(segment(a, b));
        all.back().occludes = i % 3 != 0;
        all.back().drawn = i % 5 != 0;
    }
    const Crossed c{all};
    std::vector<Crossing> expected;
    for (std::uint32_t s = 0; s < c.segments.size(); ++s) {
        if (!c.segments[s].drawn) continue;
        const auto first = static_cast<std::ptrdiff_t>(expected.size());
        for (std::uint32_t o = 0; o < c.segments.size(); ++o) {
            if (o == s || !c.segments[o].occludes) continue;
            // By Cramer's rule in world space, which is the picture's here.
            const glm::dvec3 p = c.segments[s].ends[0];
            const glm::dvec3 r = c.segments[s].ends[1] - p;
            const glm::dvec3 q = c.segments[o].ends[0];
            const glm::dvec3 t = c.segments[o].ends[1] - q;
            const double determinant = r.y * t.x - r.x * t.y;
            const double u = ((q.y - p.y) * t.x - (q.x - p.x) * t.y) / determinant;
            const double v = ((q.y - p.y) * r.x - (q.x - p.x) * r.y) / determinant;
            const glm::dvec3 point = p + u * r;
            if (u <= 0.0 || u >= 1.0 || v < 0.0 || v > 1.0) continue;
            if ((q + v * t).z - point.z > 0.05) expected.push_back({s, u});
        }
        std::sort(expected.begin() + first, expected.end(), [](auto a, auto b) { return a.at < b.at; });
    }
    ASSERT_EQ(c.crossings.size(), expected.size());
    EXPECT_GT(expected.size(), 400U);
    for (std::size_t i = 0; i < expected.size(); ++i) {
        EXPECT_EQ(c.crossings[i].segment, expected[i].segment) << i;
        EXPECT_NEAR(c.crossings[i].at, expected[i].at, 1e-9) << i;
    }
}

}  // namespace
}  // namespace inkedge::lines
