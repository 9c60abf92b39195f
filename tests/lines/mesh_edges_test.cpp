#include "lines/find/mesh_edges.h"

#include <gmock/gmock.h>

#include "lines/views.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;
using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

MeshEdges edgesOf(const Mesh& mesh, double creaseAngle = 40.0) {
    const Scene scene = sceneOf(mesh);
    return findEdges(scene.meshes()[0], scene::topologyOf(scene, 0), creaseAngle);
}

Mesh turnedOver(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i + 1], mesh.indices[i + 2]);
    return mesh;
}

TEST(MeshEdges, HoldEachSharedEdgeOnceAndCreasesByTheirBend) {
    const MeshEdges edges = edgesOf(cube());
    EXPECT_THAT(edges.shared.halfEdges, SizeIs(18));  // 12, and a diagonal a side
    EXPECT_THAT(edges.creases, SizeIs(12));
    EXPECT_THAT(edges.shared.against, Each(0));
    EXPECT_THAT(edges.many, IsEmpty());
    for (std::size_t e = 0; e < 18; ++e) EXPECT_EQ(edges.shared.halfEdges[e] / 3, edges.shared.faces[2 * e]);
}

TEST(MeshEdges, AreSplitWhereTheyAreCreasesOrShadedWithDifferentNormals) {
    const auto split = [](const Mesh& mesh) {
        const Scene scene = sceneOf(mesh);
        const MeshEdges edges = findEdges(scene.meshes()[0], scene::topologyOf(scene, 0), 40.0);
        std::size_t count = 0;
        for (std::uint32_t e = 0; e < edges.shared.halfEdges.size(); ++e)
            count += isSplit(scene.meshes()[0], scene::topologyOf(scene, 0), edges, e) ? 1 : 0;
        return count;
    };
    EXPECT_EQ(split(cube()), 12U);
    EXPECT_EQ(split(sphere()), 0U);
    Mesh bent;  // by 20 degrees, but each face with its own normals
    bent.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, -1, -0.36F}};
    bent.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, -0.34F, 0.94F}, {0, -0.34F, 0.94F}, {0, -0.34F, 0.94F}};
    bent.indices = {0, 1, 2, 3, 5, 4};
    EXPECT_EQ(split(bent), 1U);
}

TEST(MeshEdges, KnowWhichSideOfClosedComponentsIsOut) {
    EXPECT_THAT(edgesOf(cube()).closed, Each(1));
    EXPECT_THAT(edgesOf(turnedOver(cube())).closed, Each(-1));
    EXPECT_THAT(edgesOf(sheet(2.0, 3)).closed, Each(0));
    Mesh open = cube();  // without a face
    open.indices.resize(open.indices.size() - 3);
    EXPECT_THAT(edgesOf(open).closed, Each(0));
    Mesh against = cube();  // with a face turned over
    std::swap(against.indices[1], against.indices[2]);
    const MeshEdges edges = edgesOf(against);
    EXPECT_THAT(edges.closed, Each(0));
    EXPECT_EQ(std::ranges::count(edges.shared.against, 1), 3);
}

TEST(MeshEdges, OfManyFacesStandTogether) {
    Mesh fan;  // five faces at one edge, three at another
    fan.name = "fan";
    fan.positions = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0.5F}};
    for (std::uint32_t k = 0; k < 8; ++k) {
        fan.positions.emplace_back(std::cos(0.7F * float(k)), 0.5F, std::sin(0.7F * float(k)));
        const std::uint32_t from = k < 5 ? 0 : 1;
        fan.indices.insert(fan.indices.end(), {from, from + 1, 3 + k});
    }
    const MeshEdges edges = edgesOf(fan);
    EXPECT_THAT(edges.manyBegins, ElementsAre(0, 5, 8));
    EXPECT_THAT(edges.many, SizeIs(8));
    EXPECT_THAT(edges.closed, Each(0));
}

TEST(MeshEdges, PassOverFacesTooThinForANormal) {
    // A sliver between two faces at a right angle: the crease is between those.
    Mesh mesh;
    mesh.name = "sliver";
    mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1e-6F, 0, 0.5F}, {1, 0, 0.5F}, {0, 1, 0.5F}};
    mesh.indices = {0, 1, 4, 0, 2, 1, 0, 3, 2, 2, 3, 1};
    const MeshEdges edges = edgesOf(mesh);
    for (const std::uint32_t e : edges.creases)
        for (const std::uint32_t side : {0U, 1U}) EXPECT_NE(edges.shared.faces[2 * e + side], 1U);
    EXPECT_FALSE(edges.creases.empty());
}

}  // namespace
}  // namespace inkedge::lines
