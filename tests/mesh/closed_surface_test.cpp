#include "mesh/closed_surface.h"

#include <gmock/gmock.h>

#include "mesh/connect.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::mesh {
namespace {

bool isClosed(Mesh mesh) {
    const MeshTopology topology = connect(mesh, {});
    return isClosedOutward(mesh, topology);
}

Mesh joined(Mesh a, const Mesh& b, glm::vec3 offset) {
    const auto first = static_cast<std::uint32_t>(a.positions.size());
    for (const glm::vec3& p : b.positions) a.positions.push_back(p + offset);
    for (const std::uint32_t i : b.indices) a.indices.push_back(first + i);
    return a;
}

Mesh insideOut(Mesh mesh) {
    for (std::size_t t = 0; t < mesh.indices.size(); t += 3) turnOver(mesh, t);
    return mesh;
}

TEST(FindComponents, NumbersThemByTheirFirstFaces) {
    const Mesh two = joined(scenes::cube(), scenes::cube(), {5, 0, 0});
    const Scene scene = scenes::sceneOf(two);  // with patches: each cube has six
    for (const MeshTopology& topology : {buildTopology(two), scene::topologyOf(scene, 0)}) {
        const Components components = findComponents(topology);
        EXPECT_EQ(components.count, 2U);
        for (std::uint32_t t = 0; t < 24; ++t) EXPECT_EQ(components.ofFaces[t], t / 12);
    }
}

TEST(IsClosedOutward, HoldsForSolids) {
    EXPECT_TRUE(isClosed(scenes::cube()));
    EXPECT_TRUE(isClosed(scenes::sphere()));  // whose poles have faces without area
    EXPECT_TRUE(isClosed(joined(scenes::cube(), scenes::cube(), {5, 0, 0})));
}

TEST(IsClosedOutward, FailsForWhatShowsItsBacks) {
    Mesh open = scenes::cube();
    open.indices.resize(open.indices.size() - 3);
    EXPECT_FALSE(isClosed(open)) << "open";
    EXPECT_FALSE(isClosed(insideOut(scenes::cube()))) << "inside out";
    EXPECT_FALSE(isClosed(joined(scenes::cube(), insideOut(scenes::cube(0.5)), {9, 0, 0}))) << "one of two inside out";
    Mesh mixed = scenes::cube();
    turnOver(mixed, 6);
    EXPECT_FALSE(isClosed(mixed)) << "one face turned over";
    EXPECT_FALSE(isClosed(joined(scenes::cube(), scenes::cube(), {0, 0, 0}))) << "every face twice";
    EXPECT_FALSE(isClosed(joined(scenes::cube(), scenes::cube(), {2, 2, 0}))) << "four faces at an edge";
}

}  // namespace
}  // namespace inkedge::mesh
