#include "lines/see/ray_caster.h"

#include <array>

#include <gmock/gmock.h>

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;

const Size size{400, 300};

// A square in the plane z = 0, five before the eye.
struct OneSquare {
    Scene scene = sceneOf(quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}));
    RayCaster rays{scene};
    Screen screen{perspective({0, 0, 5}), scene.bounds().centre, size};
};

TEST(RayCaster, HidesWhatLiesBehindAFace) {
    const OneSquare one;
    EXPECT_TRUE(one.rays.hides(one.screen, {0.3, 0.2, -1}, {}));
    EXPECT_FALSE(one.rays.hides(one.screen, {0.3, 0.2, 1}, {}));
    EXPECT_FALSE(one.rays.hides(one.screen, {1.5, 0.2, -1}, {}));
    // Both sides of a face stop rays.
    const Screen behind{perspective({0, 0, -5}), one.scene.bounds().centre, size};
    EXPECT_TRUE(one.rays.hides(behind, {0.3, 0.2, 1}, {}));
}

TEST(RayCaster, NeedsAHundredThousandthOfTheDistance) {
    const OneSquare one;
    EXPECT_FALSE(one.rays.hides(one.screen, {0.3, 0.2, 0}, {}));
    EXPECT_FALSE(one.rays.hides(one.screen, {0.3, 0.2, -0.9e-5 * 5}, {}));
    EXPECT_TRUE(one.rays.hides(one.screen, {0.3, 0.2, -1.2e-5 * 5}, {}));
    EXPECT_FALSE(one.rays.hides(one.screen, {0.0, 0.0, -0.4}, {}, {0.5}));  // slack
    EXPECT_TRUE(one.rays.hides(one.screen, {0.0, 0.0, -0.6}, {}, {0.5}));
}

TEST(RayCaster, DoesNotCountAPointsOwnFaces) {
    const OneSquare one;
    const std::array<scene::SceneFace, 2> own{scene::SceneFace{0, 0}, scene::SceneFace{0, 1}};
    EXPECT_FALSE(one.rays.hides(one.screen, {0.3, 0.2, -1}, own));
    // But those behind them.
    const Scene two = sceneOf({{quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}), glm::dmat4{1.0}},
                               {quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}), translation({0, 0, -0.5})}});
    const RayCaster rays{two};
    const Screen screen{perspective({0, 0, 5}), two.bounds().centre, size};
    EXPECT_TRUE(rays.hides(screen, glm::dvec3{0.3, 0.2, -1} - two.bounds().centre, own));
}

TEST(RayCaster, GivesSlackToTheFacesOfOnePart) {
    const Mesh square = quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    const Scene two = sceneOf({{square, translation({0, 0, 0.2})}, {square, glm::dmat4{1.0}}});
    const RayCaster rays{two};
    const SurfaceComponents parts{two, {}};
    const Screen screen{perspective({0, 0, 5}), two.bounds().centre, size};
    const auto hidden = [&](double z, std::uint32_t instance) {
        return rays.hides(screen, glm::dvec3{0.3, 0.2, z} - two.bounds().centre, {},
                          {0.5, &parts, parts.of({instance, 0})});
    };
    EXPECT_FALSE(hidden(0.1, 0));
    EXPECT_TRUE(hidden(0.1, 1));
    EXPECT_TRUE(hidden(-0.1, 0));  // by the other, behind the one that has slack
    EXPECT_TRUE(hidden(-0.4, 1));
}

TEST(RayCaster, BeginsAtTheNearPlane) {
    const OneSquare one;
    Camera camera = perspective({0, 0, 5});
    for (const double near : {4.9, 5.1}) {
        camera.near = near;
        const Screen screen{camera, one.scene.bounds().centre, size};
        EXPECT_EQ(one.rays.hides(screen, {0.0, 0.1, -1}, {}), near < 5.0);
        EXPECT_EQ(one.rays.meets(screen, {0.0, 0.1, -1}), near < 5.0);
    }
}

TEST(RayCaster, SeesAsWellFromFarOff) {
    const OneSquare one;
    for (const double away : {1e3, 3e4}) {
        const Screen screen{perspective({0, 0, away}), one.scene.bounds().centre, size};
        EXPECT_TRUE(one.rays.hides(screen, {0.3, 0.2, -2e-5 * away}, {}));
        EXPECT_FALSE(one.rays.hides(screen, {0.3, 0.2, 0.1}, {}));
        EXPECT_FALSE(one.rays.hides(screen, {1.001, 0.2, -2e-5 * away}, {}));
    }
}

TEST(RayCaster, MeetsFacesBeforeAndBehindAPoint) {
    const OneSquare one;
    EXPECT_TRUE(one.rays.meets(one.screen, {0, 0.1, 1}));
    EXPECT_TRUE(one.rays.meets(one.screen, {0, 0.1, -1}));
    EXPECT_FALSE(one.rays.meets(one.screen, {1.3, 0.1, 0}));
}

TEST(RayCaster, LooksForFacesThatCountBetweenTwoPoints) {
    const OneSquare one;
    const auto facesUs = [](scene::SceneFace, glm::dvec3 normal) { return std::abs(std::abs(normal.z) - 1.0) < 1e-12; };
    EXPECT_TRUE(one.rays.meetsBetween({0.3, 0.2, 1}, {0.3, 0.2, -1}, facesUs));
    EXPECT_FALSE(one.rays.meetsBetween({0.3, 0.2, 1}, {0.3, 0.2, 0.1}, facesUs));
    EXPECT_FALSE(
        one.rays.meetsBetween({0.3, 0.2, 1}, {0.3, 0.2, -1}, [](scene::SceneFace, glm::dvec3) { return false; }));
}

}  // namespace
}  // namespace inkedge::lines
