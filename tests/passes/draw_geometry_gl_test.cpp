#include <functional>
#include <numeric>

#include <gmock/gmock.h>

#include <inkedge/load_scene.h>
#include <inkedge/renderer.h>

#include "formats/reader.h"
#include "gl/gl_test.h"
#include "scene/prepared.h"

namespace inkedge::passes {
namespace {

const std::string assets = INKEDGE_SOURCE_DIR "/assets/";

INKEDGE_ON_EACH_BACKEND(DrawGeometry);

template <class T>
std::ptrdiff_t differences(const Image<T>& a, const Image<T>& b) {
    return std::inner_product(a.pixels().begin(), a.pixels().end(), b.pixels().begin(), std::ptrdiff_t{0}, std::plus{},
                              [](const T& x, const T& y) { return x == y ? 0 : 1; });
}

// One pass over the triangles gives every buffer as a pass for each does, to the bit: twice, so that what one view
// leaves set does not show in the next. The assets have coplanar layers, mirrors, shears and single-sided faces.
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
                EXPECT_EQ(both.depth, surface.depth) << asset;
                EXPECT_EQ(both.windowDepth, surface.windowDepth) << asset;
                EXPECT_EQ(both.normal, surface.normal) << asset;
                EXPECT_EQ(both.types, planes.types) << asset;
                EXPECT_EQ(both.ids, planes.ids) << asset;
                EXPECT_EQ(both.picture, planes.picture) << asset;
            }
            const Maps classic = drawn(Detector::Classic, {Map::Depth, Map::Ids});
            EXPECT_EQ(classic.picture, surface.picture) << asset;
            EXPECT_EQ(classic.ids, planes.ids) << asset;
        }
    }
}

// Backs that are known to be hidden are skipped, unseen from outside or inside. Fronts and backs meet at a silhouette:
// as vertices snap to a grid of 1/256 pixel, the whole drawing may show the back there. So a few pixels may differ in
// what they see, but hardly in how far away it is, and the ink around them (a stroke of 1.5 pixels touches 12) with
// them.
constexpr float rounding = 3.5e-4F;         // of the depth: a tenth of what a pixel spans there
constexpr std::ptrdiff_t maxDifferent = 4;  // of 43200 pixels

TEST_P(DrawGeometry, SkipsHiddenBacksUnseen) {
    int hiding = 0;
    for (const char* asset : {"gear.glb", "boxes.glb", "touching_solids.glb", "torus_knot.glb", "blob.glb",
                              "bracket.glb", "sheet.glb", "teapot.glb", "primitives.glb"}) {
        Scene::Data data = formats::readModel({assets + asset}, {});
        const Scene skipping{data};
        data.source.knowsSides = false;
        const Scene drawing{std::move(data)};
        for (std::size_t i = 0; i < skipping.meshes().size(); ++i) {
            hiding += scene::hidesItsBacks(skipping, i) ? 1 : 0;
            EXPECT_FALSE(scene::hidesItsBacks(drawing, i));
        }
        CameraSettings inside;
        inside.position = skipping.bounds().centre + glm::dvec3{0.1, 0.2, 0.3} * skipping.bounds().radius;
        CameraSettings level;
        level.elevationAngle = 0.0;
        level.orthographicHeight = 0.0;
        for (const CameraSettings& look : {CameraSettings{}, level, inside}) {
            const auto drawn = [&](const Scene& scene) {
                Settings settings;
                settings.picture.size = {240, 180};
                settings.maps = {Map::Depth, Map::Normal, Map::Ids};
                return renderer().render(scene, frameCamera(scene, look, settings.picture.size), settings);
            };
            const Maps skipped = drawn(skipping);
            const Maps whole = drawn(drawing);
            std::ptrdiff_t different = 0;
            for (std::size_t i = 0; i < whole.depth.pixels().size(); ++i) {
                different += skipped.ids.pixels()[4 * i] == whole.ids.pixels()[4 * i] ? 0 : 1;
                EXPECT_NEAR(skipped.depth.pixels()[i], whole.depth.pixels()[i], rounding * whole.depth.pixels()[i])
                    << asset;
            }
            EXPECT_LE(different, maxDifferent) << asset;
            EXPECT_LE(differences(skipped.picture, whole.picture), 12 * maxDifferent) << asset;
        }
    }
    EXPECT_GE(hiding, 5);
}

}  // namespace
}  // namespace inkedge::passes
