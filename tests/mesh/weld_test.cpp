#include "mesh/weld.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>

namespace inkedge::mesh {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(WeldByPosition, numbersPointsInOrderOfAppearance) {
    const std::vector<glm::vec3> positions{{5, 0, 0}, {1, 2, 3}, {5, 0, 0}, {0, 0, 0}, {1, 2, 3}, {5, 0, 0}};
    const Weld weld = weldByPosition(positions);
    EXPECT_THAT(weld.point, ElementsAre(0, 1, 0, 2, 1, 0));
    EXPECT_EQ(weld.pointCount, 3U);
}

TEST(WeldByPosition, weldsMinusZeroToZero) {
    const Weld weld = weldByPosition(std::vector<glm::vec3>{{0, 1, 0}, {-0.0F, 1, 0}, {0, 1, -0.0F}});
    EXPECT_THAT(weld.point, ElementsAre(0, 0, 0));
    EXPECT_EQ(weld.pointCount, 1U);
}

TEST(WeldByPosition, bearsPointsFarOffAndCloseTogether) {
    const Weld weld = weldByPosition(std::vector<glm::vec3>{{3e38F, 0, 0}, {3e38F, 1e-30F, 0}, {3e38F, 0, 1e-30F}});
    EXPECT_EQ(weld.pointCount, 3U);
}

// The box of these positions has a diagonal of 1000 or a little more: the tolerance is 5e-4.
std::vector<glm::vec3> near(glm::vec3 a, glm::vec3 b) { return {{-500, 0, 0}, {500, 0, 0}, a, b}; }

TEST(WeldByPosition, weldsWhatRoundingSetsApart) {
    const float tolerance = static_cast<float>(weldTolerance * 1000.0);
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = -9; i <= 9; ++i) {  // wherever the two stand in a grid of cells
            const glm::vec3 a{0.23F * static_cast<float>(i) * tolerance};
            glm::vec3 b = a;
            b[axis] += 0.9F * tolerance;
            EXPECT_THAT(weldByPosition(near(a, b)).point, ElementsAre(0, 1, 2, 2)) << i;
            EXPECT_THAT(weldByPosition(near(b, a)).point, ElementsAre(0, 1, 2, 2)) << i;
            b[axis] = a[axis] + 1.1F * tolerance;
            EXPECT_THAT(weldByPosition(near(a, b)).point, ElementsAre(0, 1, 2, 3)) << i;
        }
    }
}

TEST(WeldByPosition, keepsTheEndsOfARowOfNeighboursApart) {
    // Each is within the tolerance of the next, but not of the one after it: welding must not run along the row.
    const float step = static_cast<float>(0.7 * weldTolerance * 1000.0);
    std::vector<glm::vec3> positions = near({0, 0, 0}, {step, 0, 0});
    positions.emplace_back(2 * step, 0, 0);
    positions.emplace_back(3 * step, 0, 0);
    EXPECT_THAT(weldByPosition(positions).point, ElementsAre(0, 1, 2, 2, 3, 3));
}

TEST(WeldByPosition, weldsEqualPositionsWhateverStandsNearThemSince) {
    // The second is welded to the first; the third is near the second, too, but not near the first.
    const auto tolerance = static_cast<float>(weldTolerance * 1000.0);
    std::vector<glm::vec3> positions = near({0, 0, 0}, {0.7F * tolerance, 0, 0});
    positions.emplace_back(1.4F * tolerance, 0, 0);
    positions.emplace_back(0.7F * tolerance, 0, 0);
    EXPECT_THAT(weldByPosition(positions).point, ElementsAre(0, 1, 2, 2, 3, 2));
}

TEST(WeldByPosition, weldsAllAtOnePosition) {
    const Weld weld = weldByPosition(std::vector<glm::vec3>(3, glm::vec3{1, 2, 3}));
    EXPECT_THAT(weld.point, ElementsAre(0, 0, 0));
    EXPECT_EQ(weld.pointCount, 1U);
}

TEST(WeldByPosition, meansTheSameAtAnySize) {
    for (const float size : {1e-30F, 1.0F, 1e30F}) {
        std::vector<glm::vec3> positions = near({0, 0, 0}, {4e-4F, 0, 0});
        positions.emplace_back(0.0F, 6e-4F, 0.0F);
        for (glm::vec3& p : positions) p *= size;
        EXPECT_THAT(weldByPosition(positions).point, ElementsAre(0, 1, 2, 2, 3)) << size;
    }
}

TEST(WeldByPosition, keepsApartWhatHasItsCoordinatesSwapped) {
    const Weld weld = weldByPosition(std::vector<glm::vec3>{{1, 2, 3}, {2, 1, 3}, {3, 2, 1}, {1, 3, 2}});
    EXPECT_EQ(weld.pointCount, 4U);
}

TEST(WeldByPosition, ofNothingIsNothing) {
    const Weld weld = weldByPosition({});
    EXPECT_THAT(weld.point, IsEmpty());
    EXPECT_EQ(weld.pointCount, 0U);
}

TEST(WeldByPosition, findsEveryPairAmongMany) {
    // Each point of a 40^3 grid twice, far apart in the list, with coordinates of few differing bits.
    std::vector<glm::vec3> positions;
    for (int copy = 0; copy < 2; ++copy) {
        for (int i = 0; i < 64000; ++i) positions.emplace_back(i % 40, (i / 40) % 40, i / 1600);
    }
    const Weld weld = weldByPosition(positions);
    ASSERT_EQ(weld.pointCount, 64000U);
    for (std::uint32_t i = 0; i < 64000; ++i) {
        ASSERT_EQ(weld.point[i], i);
        ASSERT_EQ(weld.point[64000 + i], i);
    }
}

}  // namespace
}  // namespace inkedge::mesh
