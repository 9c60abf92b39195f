#include <gmock/gmock.h>

#include <inkedge/renderer.h>

#include "gl/gl_test.h"

namespace inkedge {
namespace {

const std::string assets = INKEDGE_SOURCE_DIR "/assets/";

INKEDGE_ON_EACH_BACKEND(DrawGeometry);

// One pass over the triangles gives every buffer as a pass for each does, to the bit: twice, so that what one view leaves
// set does not show in the next. The assets have coplanar layers, mirrors, shears and single-sided faces.
TEST_P(DrawGeometry, InOnePassEqualsAPassForEach) {
    for (const char* asset : {"touching_solids.glb", "primitives.glb", "lantern.glb", "teapot.glb"}) {
        LoadSettings load;
        load.backFaces = BackFaces::Material;
        const Scene scene = loadScene(assets + asset, load);
        for (const LightSpace lightSpace : {LightSpace::Camera, LightSpace::World}) {
            const auto drawn = [&](Detector detector, std::vector<Map> maps) {
                Settings settings;
                settings.picture.size = {157, 93};
                settings.detector.detector = detector;
                settings.detector.lightSpace = lightSpace;
                settings.maps = std::move(maps);
                return renderer().render(scene, frameCamera(scene, {}, settings.picture.size), settings);
            };
            const Maps surface = drawn(Detector::Classic, {Map::Depth, Map::Normal, Map::Edges});
            const Maps planes = drawn(Detector::Planes, {Map::Types, Map::Ids});
            for (int time = 0; time < 2; ++time) {
                const Maps both = drawn(Detector::Planes, {Map::Depth, Map::Normal, Map::Types, Map::Ids});
                EXPECT_EQ(both.depth.pixels, surface.depth.pixels) << asset;
                EXPECT_EQ(both.windowDepth.pixels, surface.windowDepth.pixels) << asset;
                EXPECT_EQ(both.normal.pixels, surface.normal.pixels) << asset;
                EXPECT_EQ(both.types.pixels, planes.types.pixels) << asset;
                EXPECT_EQ(both.ids.pixels, planes.ids.pixels) << asset;
                EXPECT_EQ(both.picture.pixels, planes.picture.pixels) << asset;
            }
            const Maps classic = drawn(Detector::Classic, {Map::Depth, Map::Ids});
            EXPECT_EQ(classic.picture.pixels, surface.picture.pixels) << asset;
            EXPECT_EQ(classic.ids.pixels, planes.ids.pixels) << asset;
        }
    }
}

}  // namespace
}  // namespace inkedge
