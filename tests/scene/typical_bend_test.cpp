#include "scene/typical_bend.h"

#include <gtest/gtest.h>

#include "scenes.h"

namespace inkedge::scene {
namespace {

TEST(TypicalBend, ofASphereIsItsFacets) {
    // Bands of 360 / 64 degrees meet along edges of about that length; diagonals hardly bend.
    EXPECT_NEAR(typicalBend(scenes::sceneOf(scenes::sphere(1.0, 64))), 360.0 / 64.0, 0.6);
    EXPECT_NEAR(typicalBend(scenes::sceneOf(scenes::sphere(1.0, 32))), 360.0 / 32.0, 1.2);
}

TEST(TypicalBend, isTheSameAtAnySize) {
    const double bend = typicalBend(scenes::sceneOf(scenes::sphere(1.0, 32)));
    EXPECT_NEAR(typicalBend(scenes::sceneOf(scenes::sphere(1e-3, 32))), bend, 0.01);
    EXPECT_NEAR(typicalBend(scenes::sceneOf(scenes::sphere(1e6, 32))), bend, 0.01);
}

TEST(TypicalBend, leavesOutCreasesAndFlatFaces) {
    EXPECT_EQ(typicalBend(scenes::sceneOf(scenes::cube())), 1.0);
    LoadSettings blunt;
    blunt.creaseAngle = 91.0;
    EXPECT_NEAR(typicalBend(scenes::sceneOf({{scenes::cube(), glm::dmat4{1.0}}}, blunt)), 90.0, 1e-6);
}

TEST(TypicalBend, ofALargeMeshIsThatOfAPart) {
    // 2 * 512 * 255 * 3 half-edges: every third would be the same one of each triangle. Bands bend less along the
    // sphere than around it.
    EXPECT_NEAR(typicalBend(scenes::sceneOf(scenes::sphere(1.0, 512))), 360.0 / 512.0, 0.1);
}

}  // namespace
}  // namespace inkedge::scene
