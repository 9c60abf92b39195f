#include "lines/chains.h"

#include <algorithm>

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const Size size{400, 300};

// A pixel a unit, the origin in the picture's middle, looking along -z from z = 10.
Screen flat() { return {views::orthographic({0, 0, 10}, 300.0), glm::dvec3{0.0}, size}; }

Segment segment(glm::dvec3 a, Key keyA, glm::dvec3 b, Key keyB, Curve curve = Curve::Crease) {
    Segment s;
    s.curve = curve;
    s.ends = {a, b};
    s.keys = {keyA, keyB};
    return s;
}

struct Chained {
    std::vector<Segment> segments;
    std::vector<ScreenSegment> projected;
    std::vector<Chain> chains;
    explicit Chained(std::vector<Segment> all, const Screen& screen = flat())
        : segments{std::move(all)}, projected{project(segments, screen)}, chains{chainSegments(segments, projected)} {}
};

std::vector<std::uint32_t> segmentsOf(const Chain& chain) {
    std::vector<std::uint32_t> all;
    for (const Chain::Link& link : chain.links) all.push_back(link.segment);
    return all;
}

TEST(Chains, JoinEndToEndHoweverTheirSegmentsRun) {
    const Chained c{{segment({0, 0, 0}, 1, {10, 0, 0}, 2), segment({20, 0, 0}, 3, {10, 0, 0}, 2),
                     segment({20, 0, 0}, 3, {30, 5, 0}, 4)}};
    ASSERT_THAT(c.chains, SizeIs(1));
    EXPECT_FALSE(c.chains[0].closed);
    EXPECT_THAT(segmentsOf(c.chains[0]), ElementsAre(0, 1, 2));
    EXPECT_FALSE(c.chains[0].links[0].reversed);
    EXPECT_TRUE(c.chains[0].links[1].reversed);
    EXPECT_FALSE(c.chains[0].links[2].reversed);
}

TEST(Chains, CloseWhereTheyComeBack) {
    const Chained c{{segment({0, 0, 0}, 1, {10, 0, 0}, 2), segment({10, 10, 0}, 3, {10, 0, 0}, 2),
                     segment({10, 10, 0}, 3, {0, 0, 0}, 1)}};
    ASSERT_THAT(c.chains, SizeIs(1));
    EXPECT_TRUE(c.chains[0].closed);
    EXPECT_THAT(c.chains[0].links, SizeIs(3));
}

TEST(Chains, GoStraightOnAtAJunction) {
    // A T: the bar goes on, the stem ends.
    const Chained bar{{segment({-10, 0, 0}, 1, {0, 0, 0}, 2), segment({0, 0, 0}, 2, {0, -10, 0}, 3),
                       segment({0, 0, 0}, 2, {10, 1, 0}, 4)}};
    ASSERT_THAT(bar.chains, SizeIs(2));
    EXPECT_THAT(segmentsOf(bar.chains[0]), ElementsAre(0, 2));
    EXPECT_THAT(segmentsOf(bar.chains[1]), ElementsAre(1));
    // Where the straightest two bend by 60 degrees or more none goes on.
    for (const double widest : {119.0, 121.0}) {
        const auto arm = [](double degrees, Key key) {
            return segment({0, 0, 0}, 1,
                           {10 * std::cos(glm::radians(degrees)), 10 * std::sin(glm::radians(degrees)), 0}, key);
        };
        const Chained fan{{arm(0.0, 2), arm(60.0, 3), arm(widest, 4)}};
        EXPECT_THAT(fan.chains, SizeIs(widest < 120.0 ? 3 : 2)) << widest;
    }
}

TEST(Chains, TakeBothWaysThroughACrossroads) {
    const Chained c{{segment({-10, 0, 0}, 1, {0, 0, 0}, 9), segment({0, -10, 0}, 2, {0, 0, 0}, 9),
                     segment({0, 0, 0}, 9, {10, 0, 0}, 3), segment({0, 0, 0}, 9, {0, 10, 0}, 4)}};
    ASSERT_THAT(c.chains, SizeIs(2));
    EXPECT_THAT(segmentsOf(c.chains[0]), ElementsAre(0, 2));
    EXPECT_THAT(segmentsOf(c.chains[1]), ElementsAre(1, 3));
}

TEST(Chains, KeepToOneTypeAndToWhatIsDrawn) {
    auto onlyHides = segment({10, 0, 0}, 2, {20, 0, 0}, 3);
    onlyHides.drawn = false;
    const Chained c{
        {segment({0, 0, 0}, 1, {10, 0, 0}, 2), segment({10, 0, 0}, 2, {20, 0, 0}, 3, Curve::Contour), onlyHides}};
    ASSERT_THAT(c.chains, SizeIs(2));
    for (const Chain& chain : c.chains) EXPECT_THAT(chain.links, SizeIs(1));
}

TEST(Chains, HoldEveryDrawnSegmentOnce) {
    // A grid of streets: junctions of 2, 3 and 4.
    std::vector<Segment> streets;
    const auto key = [](int x, int y) { return Key(100 * x + y); };
    for (int x = 0; x < 6; ++x) {
        for (int y = 0; y < 6; ++y) {
            if (x < 5)
                streets.push_back(segment({10 * x, 10 * y, 0}, key(x, y), {10 * x + 10, 10 * y, 0}, key(x + 1, y)));
            if (y < 5)
                streets.push_back(segment({10 * x, 10 * y, 0}, key(x, y), {10 * x, 10 * y + 10, 0}, key(x, y + 1)));
        }
    }
    const Chained c{streets};
    std::vector<int> uses(streets.size(), 0);
    for (const Chain& chain : c.chains) {
        for (std::size_t i = 0; i < chain.links.size(); ++i) {
            ++uses[chain.links[i].segment];
            if (i == 0) continue;
            const auto end = [&](std::size_t link, bool last) {
                return c.segments[chain.links[link].segment].keys[chain.links[link].reversed != last ? 1 : 0];
            };
            EXPECT_EQ(end(i - 1, true), end(i, false));
        }
    }
    EXPECT_THAT(uses, testing::Each(1));
}

TEST(Projection, CutsAtTheNearPlaneAndNothingGoesOnThere) {
    Camera camera = views::perspective({0, 0, 0}, {0, 0, -1});
    camera.near = 1.0;
    const Screen screen{camera, glm::dvec3{0.0}, size};
    const glm::dvec3 before{0.1, 0, -3};
    const glm::dvec3 behind{0.1, 0, 5};
    const Chained c{
        {segment(before, 1, behind, 2), segment(behind, 2, {0.2, 0, -3}, 3), segment({0, 0, 2}, 4, {1, 0, 0}, 5)},
        screen};
    ASSERT_THAT(c.segments, SizeIs(2));
    ASSERT_THAT(c.projected, SizeIs(2));
    EXPECT_THAT(c.chains, SizeIs(2)) << "joined behind the camera";
    EXPECT_EQ(c.segments[0].keys[0], 1U);
    EXPECT_EQ(c.segments[0].keys[1], noKey);
    EXPECT_NEAR(screen.depth(c.projected[0].world[1]), camera.near, 1e-6);
    EXPECT_EQ(c.projected[0].world[0], before);
    EXPECT_EQ(c.segments[0].ends[1], behind) << "the surface's own shape stays";
    for (const ScreenSegment& s : c.projected)
        for (const ScreenPoint& end : s.ends) EXPECT_TRUE(std::isfinite(end.pixel.x) && std::isfinite(end.pixel.y));
}

TEST(Projection, LeavesOutWhatIsFarOffThePicture) {
    const Chained c{{segment({-500, 0, 0}, 1, {-400, 100, 0}, 2), segment({-500, 0, 0}, 1, {500, 0, 0}, 3),
                     segment({0, 0, 20}, 4, {1, 0, 20}, 5)}};
    ASSERT_THAT(c.segments, SizeIs(1));  // the one across; not that to the left, nor that behind the camera
    EXPECT_EQ(c.segments[0].keys[1], 3U);
    EXPECT_DOUBLE_EQ(c.projected[0].ends[0].pixel.x, -300.0);
    EXPECT_DOUBLE_EQ(c.projected[0].ends[0].pixel.y, 150.0);
}

TEST(Chains, OfNothingAreNone) { EXPECT_THAT(Chained{{}}.chains, IsEmpty()); }

}  // namespace
}  // namespace inkedge::lines
