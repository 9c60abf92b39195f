#include "lines/see/surface_components.h"

#include <gmock/gmock.h>

#include "lines/views.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;

struct Components {
    Scene scene;
    std::vector<MeshEdges> edges;
    std::vector<BorderSegment> borders;
    SurfaceComponents components;

    explicit Components(const std::vector<std::pair<Mesh, glm::dmat4>>& instances)
        : scene{sceneOf(instances)},
          edges{edgesOf(scene)},
          borders{findBorderSegments(scene, edges)},
          components{scene, borders} {}

    static std::vector<MeshEdges> edgesOf(const Scene& scene) {
        std::vector<MeshEdges> edges;
        for (std::size_t i = 0; i < scene.meshes().size(); ++i)
            edges.push_back(findEdges(scene.meshes()[i], scene::topologyOf(scene, i), scene.creaseAngle()));
        return edges;
    }
};

const glm::dmat4 here{1.0};

TEST(SurfaceComponents, AreConnectedAcrossEdgesSharpOrNot) {
    const Components one{{{cube(1.0), here}}};
    for (std::uint32_t t = 1; t < 12; ++t) EXPECT_EQ(one.components.of({0, t}), one.components.of({0, 0}));
    EXPECT_TRUE(one.components.areOne());
}

TEST(SurfaceComponents, OfOneMeshMayBeSeveral) {
    Mesh two = cube(1.0);
    const Mesh other = box({1, 1, 4});
    for (const std::uint32_t i : other.indices)
        two.indices.push_back(static_cast<std::uint32_t>(two.positions.size()) + i);
    two.positions.insert(two.positions.end(), other.positions.begin(), other.positions.end());
    two.normals.clear();
    const Components both{{{two, here}, {two, translation({9, 0, 0})}}};
    for (const std::uint32_t instance : {0U, 1U}) {
        EXPECT_EQ(both.components.of({instance, 0}), both.components.of({instance, 11}));
        EXPECT_NE(both.components.of({instance, 0}), both.components.of({instance, 12}));
    }
    EXPECT_NE(both.components.of({0, 0}), both.components.of({1, 0}));
    EXPECT_FALSE(both.components.areOne());
}

TEST(SurfaceComponents, GoOnAcrossSeamsOfInstances) {
    const Mesh left = quad({-2, 0, -1}, {-2, 0, 1}, {0, 0, 1}, {0, 0, -1});
    const Mesh right = quad({0, 0, -1}, {0, 0, 1}, {2, 0, 1}, {2, 0, -1});
    EXPECT_TRUE((Components{{{left, here}, {right, here}}}.components.areOne()));
    EXPECT_FALSE((Components{{{left, here}, {right, translation({0.5, 0, 0})}}}.components.areOne()));
}

TEST(SurfaceComponents, AreNearWhereTheBoxOfAnotherHoldsAPoint) {
    const Components both{{{cube(1.0), translation({-2, 0, 0})}, {cube(1.0), translation({2, 0, 0})}}};
    EXPECT_TRUE(both.components.mayBeNear({0, 0}, {2.5, 0.5, 0}, 1e-6));
    EXPECT_TRUE(both.components.mayBeNear({0, 0}, {1.4, 0, 0}, 0.2));
    EXPECT_FALSE(both.components.mayBeNear({0, 0}, {1.4, 0, 0}, 0.05));
    EXPECT_FALSE(both.components.mayBeNear({0, 0}, {-2, 0, 0}, 0.05)) << "a component is not near itself";
    std::vector<std::pair<Mesh, glm::dmat4>> many;
    for (int i = 0; i < 40; ++i) many.emplace_back(cube(1.0), translation({3.0 * i, 0, 0}));
    EXPECT_TRUE((Components{many}.components.mayBeNear({0, 0}, {0, 50, 0}, 0.05))) << "too many to look at";
}

}  // namespace
}  // namespace inkedge::lines
