#include "trace/pinholes.h"

#include <functional>

#include <gmock/gmock.h>

namespace inkedge::trace {
namespace {

using testing::ElementsAre;

constexpr unsigned right = 0x01;  // a mark between a sample and the one to its right
constexpr unsigned below = 0x10;  // and the one below

struct Plane {
    float w = 0.5F;
    float dx = 0.0F;
    float dy = 0.0F;
    float patch = 1.0F;
};

// A surface of 3 x 3 samples with a hole in its middle, through which another one is seen, marked all round.
LineBuffers hole(const Plane& seenThrough) {
    constexpr Size size{3, 3};
    LineBuffers buffers{size, {size, 4}, {size, 1}, {size, 1}};
    const auto put = [&](int x, int y, const Plane& plane) {
        const float values[]{plane.w, plane.dx, plane.dy, plane.patch};
        for (int channel = 0; channel < 4; ++channel) buffers.planes(x, y, channel) = values[channel];
    };
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) put(x, y, {});
    put(1, 1, seenThrough);
    buffers.marks(1, 1) = right | below;
    buffers.marks(0, 1) = right;
    buffers.marks(1, 0) = below;
    return buffers;
}

constexpr Plane behind{.w = 0.1F, .dx = 0.0F, .dy = 0.0F, .patch = 2.0F};
constexpr Plane nothing{.w = 0.0F, .dx = 0.0F, .dy = 0.0F, .patch = 0.0F};

// The marks of the middle, and those to its left and above it.
std::vector<unsigned> marksLeft(LineBuffers buffers, const std::function<void(LineBuffers&)>& change = {}) {
    if (change) change(buffers);
    removePinholes(buffers, Camera{}, 1.0);
    return {buffers.marks(1, 1), buffers.marks(0, 1), buffers.marks(1, 0)};
}

const auto areKept = ElementsAre(right | below, right, below);

TEST(Pinholes, LoseTheirMarks) {
    EXPECT_THAT(marksLeft(hole(behind)), ElementsAre(0, 0, 0));
    EXPECT_THAT(marksLeft(hole(nothing)), ElementsAre(0, 0, 0));
}

TEST(Pinholes, LeaveTheMarksOfOtherSteps) {
    const auto more = [](LineBuffers& buffers) {
        buffers.marks(0, 1) = right | below;
        buffers.marks(1, 0) = right | below;
    };
    EXPECT_THAT(marksLeft(hole(behind), more), ElementsAre(0, below, right));
}

TEST(Pinholes, AreNotWhatLiesInFront) {
    EXPECT_THAT(marksLeft(hole({.w = 0.9F, .dx = 0.0F, .dy = 0.0F, .patch = 2.0F})), areKept);
}

TEST(Pinholes, AreMarkedAllRound) {
    const auto open = [](LineBuffers& buffers) { buffers.marks(0, 1) = 0; };
    EXPECT_THAT(marksLeft(hole(behind), open), ElementsAre(right | below, 0, below));
}

TEST(Pinholes, HaveOneSurfaceAllRoundThatGoesOn) {
    const auto otherPatch = [](LineBuffers& buffers) { buffers.planes(2, 1, 3) = 3.0F; };
    EXPECT_THAT(marksLeft(hole(behind), otherPatch), areKept);
    const auto otherPair = [](LineBuffers& buffers) {
        for (const int y : {0, 2}) buffers.planes(1, y, 3) = 3.0F;
    };
    EXPECT_THAT(marksLeft(hole(behind), otherPair), areKept);
    const auto step = [](LineBuffers& buffers) { buffers.planes(2, 1, 0) = 5.0F; };
    EXPECT_THAT(marksLeft(hole(behind), step), areKept);
    const auto noSurface = [](LineBuffers& buffers) {
        buffers.planes(0, 1, 3) = 0.0F;
        buffers.planes(2, 1, 3) = 0.0F;
    };
    EXPECT_THAT(marksLeft(hole(behind), noSurface), areKept);
}

TEST(Pinholes, AreNotLookedForAtTheTilesRim) {
    LineBuffers buffers = hole(behind);
    buffers.marks(0, 0) = right | below;
    removePinholes(buffers, Camera{}, 1.0);
    EXPECT_EQ(buffers.marks(0, 0), right | below);
}

}  // namespace
}  // namespace inkedge::trace
