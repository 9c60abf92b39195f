#include "trace/trace_maps.h"

#include <gmock/gmock.h>

#include "scenes.h"

namespace inkedge::trace {
namespace {

using testing::ElementsAre;

std::vector<std::uint32_t> idsAt(const Image<std::uint32_t>& ids, int x, int y) {
    return {ids(x, y, 0), ids(x, y, 1), ids(x, y, 2), ids(x, y, 3)};
}

TEST(TraceIds, NamePatchNodeAndMaterialAndThePatchAcrossALine) {
    Mesh first = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});  // triangles 0 and 1
    first.materials = {5, 6};
    const Mesh second = scenes::quad({2, -1, 0}, {3, -1, 0}, {3, 1, 0}, {2, 1, 0});  // 2 and 3
    const Scene scene = scenes::sceneOf({{first, glm::dmat4{1.0}}, {second, glm::dmat4{1.0}}});
    constexpr Size size{3, 2};
    const std::vector<std::uint32_t> firstTriangles{0, 2};
    const ScreenTriangles triangles{scene, firstTriangles, Camera{}, size};
    LineBuffers buffers{size, {size, 4}, {size, 1}, {size, 1}};
    const std::uint32_t seen[]{2, 2, 4, 1, 0, 0};  // counted from 1, 0: none
    for (int i = 0; i < 6; ++i) buffers.triangles(i % 3, i / 3) = seen[i];
    buffers.marks(1, 0) = 0x11;  // to its right and below
    const Image<std::uint32_t> ids = traceIds(buffers, scene, triangles);
    EXPECT_THAT(idsAt(ids, 0, 0), ElementsAre(1, 0, 1, 6));
    EXPECT_THAT(idsAt(ids, 0, 1), ElementsAre(1, 0, 1, 5));
    EXPECT_THAT(idsAt(ids, 1, 0), ElementsAre(1, 0, 1, 6));  // across to the right: patch 2; below: nothing, the last
    EXPECT_THAT(idsAt(ids, 2, 0), ElementsAre(2, 1, 2, 0));
    EXPECT_THAT(idsAt(ids, 1, 1), ElementsAre(0, 1, 0, 0));
    EXPECT_THAT(idsAt(ids, 2, 1), ElementsAre(0, 0, 0, 0));
}

}  // namespace
}  // namespace inkedge::trace
