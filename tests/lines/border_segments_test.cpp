#include "lines/find/border_segments.h"

#include <gmock/gmock.h>
#include <glm/trigonometric.hpp>

#include "lines/segment.h"
#include "lines/views.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;

std::vector<BorderSegment> partsOf(const Scene& scene) {
    std::vector<MeshEdges> edges;
    for (std::size_t i = 0; i < scene.meshes().size(); ++i)
        edges.push_back(findEdges(scene.meshes()[i], scene::topologyOf(scene, i), scene.creaseAngle()));
    return findBorderSegments(scene, edges);
}

const Mesh left = quad({-2, 0, -1}, {-2, 0, 1}, {0, 0, 1}, {0, 0, -1});
const Mesh right = quad({0, 0, -1}, {0, 0, 1}, {2, 0, 1}, {2, 0, -1});

TEST(BorderSegments, OfASheetAreItsBorders) {
    const auto parts = partsOf(sceneOf(sheet(2.0, 3)));
    EXPECT_EQ(parts.size(), 12U);
    for (const BorderSegment& part : parts) EXPECT_EQ(part.other, noFace);
    EXPECT_TRUE(partsOf(sceneOf(cube())).empty());
}

TEST(BorderSegments, ThatTouchAreNamedOnceWithTheFaceBeyond) {
    // Turned about the shared edge: on, bent by 60 degrees, folded back.
    for (const double bend : {0.0, 60.0, 180.0}) {
        const auto parts = partsOf(sceneOf({{left, glm::dmat4{1.0}}, {right, rotation(bend, {0, 0, 1})}}));
        const auto shared =
            std::ranges::count_if(parts, [](const BorderSegment& part) { return part.other != noFace; });
        EXPECT_EQ(shared, bend == 180.0 ? 0 : 1) << bend;
        EXPECT_EQ(parts.size(), bend == 180.0 ? 8U : 7U) << bend;
        for (const BorderSegment& part : parts) {
            if (part.other == noFace) continue;
            EXPECT_EQ(part.other.instance, 1U);
            EXPECT_EQ(part.bends, bend > 0.0);
        }
    }
}

TEST(BorderSegments, EndWhereTheOtherOneEnds) {
    // The right one is shifted by half a unit: a quarter of the shared edge is free on each.
    const auto parts = partsOf(sceneOf({{left, glm::dmat4{1.0}}, {right, translation({0, 0, 0.5})}}));
    double shared = 0.0;
    double free = 0.0;  // of edges that have a shared part too
    for (const BorderSegment& part : parts) {
        if (part.other != noFace) shared += part.to - part.from;
        if (part.other == noFace && part.to - part.from < 0.9) free += part.to - part.from;
    }
    EXPECT_NEAR(shared, 0.75, 1e-6);
    EXPECT_NEAR(free, 0.5, 1e-6);
}

}  // namespace
}  // namespace inkedge::lines
