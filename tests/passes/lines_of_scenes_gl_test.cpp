// Lines of scenes: what they are, whatever the scale and the view.
#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <inkedge/load_scene.h>

#include "gl/gl_test.h"
#include "passes/flat_view.h"
#include "passes/line_maps.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

using flat_view::flatCamera;
using flat_view::square;
using namespace line_maps;
using testing::Each;
using testing::ElementsAre;

INKEDGE_ON_EACH_BACKEND(LinesOfScenes);

// A scene whose every instance is moved by one more transform, in double precision.
Scene transformed(const Scene& scene, const glm::dmat4& transform) {
    Scene::Data data;
    data.meshes = scene.meshes();
    data.nodes = scene.nodes();
    data.instances = scene.instances();
    data.nodes = scene.nodes();
    for (Instance& instance : data.instances) instance.transform = transform * instance.transform;
    return Scene{std::move(data)};
}

// The share of line pixels that one picture has and the other has not.
double changedShare(const Maps& a, const Maps& b) {
    int changed = 0;
    for (std::size_t i = 0; i < a.types.pixels().size(); ++i) {
        changed += (a.types.pixels()[i] != 0) != (b.types.pixels()[i] != 0) ? 1 : 0;
    }
    EXPECT_GT(countMarked(a.types), 500);
    return static_cast<double>(changed) / countMarked(a.types);
}

// Scales and offsets round positions in view space differently, in the last bit of a float: a pixel whose centre an
// edge passes within 1e-4 pixel of may change sides, and a decision that close to its limit may turn.
constexpr double rounding = 0.003;

constexpr Size pictureSize{240, 200};

CameraSettings threeQuarters(bool orthographic) {
    CameraSettings cameraSettings;
    cameraSettings.azimuthAngle = 33.0;
    cameraSettings.elevationAngle = 24.0;
    if (orthographic) cameraSettings.orthographicHeight = 0.0;
    return cameraSettings;
}

TEST_P(LinesOfScenes, doNotDependOnTheScenesSizeOrPosition) {
    for (const char* asset : {"gear.glb", "torus_knot.glb", "touching_solids.glb"}) {
        const Scene scene = loadScene(assets + asset);
        for (const bool orthographic : {false, true}) {
            const CameraSettings cameraSettings = threeQuarters(orthographic);
            const Maps original =
                renderer().render(scene, frameCamera(scene, cameraSettings, pictureSize), linesOf(pictureSize));
            const auto compare = [&](const glm::dmat4& transform, double limit, const std::string& what) {
                const Scene other = transformed(scene, transform);
                const Maps maps =
                    renderer().render(other, frameCamera(other, cameraSettings, pictureSize), linesOf(pictureSize));
                EXPECT_LE(changedShare(original, maps), limit) << asset << ' ' << what;
            };
            for (const double scale : {1e-4, 0.37, 1e4}) {
                compare(scenes::scaling(glm::dvec3{scale}), rounding, "scaled by " + std::to_string(scale));
            }
            const double far = 1e6 * scene.bounds().radius;
            compare(scenes::translation({far, -0.7 * far, 0.3 * far}), rounding, "moved by a million radii");
            compare(scenes::scaling(glm::dvec3{1e-4}) * scenes::translation({-far, far, far}), rounding,
                    "scaled and moved");
        }
    }
}

TEST_P(LinesOfScenes, doNotDependOnNearAndFar) {
    const Scene scene = loadScene(assets + "gear.glb");
    for (const bool orthographic : {false, true}) {
        const Camera camera = frameCamera(scene, threeQuarters(orthographic), pictureSize);
        const Maps original = renderer().render(scene, camera, linesOf(pictureSize));
        // Reversed float depth in perspective keeps its precision; an orthographic view's is spread evenly over its
        // range.
        for (const double factor : orthographic ? std::vector{3.0, 30.0} : std::vector{10.0, 1e3}) {
            Camera moved = camera;
            moved.near = orthographic ? camera.near - factor * scene.bounds().radius : camera.near / factor;
            moved.far = orthographic ? camera.far + factor * scene.bounds().radius : camera.far * factor;
            EXPECT_LE(changedShare(original, renderer().render(scene, moved, linesOf(pictureSize))), rounding)
                << factor;
        }
    }
}

struct Ids {
    std::uint32_t patch;
    std::uint32_t across;
    std::uint32_t node;
    std::uint32_t material;
    friend bool operator==(const Ids&, const Ids&) = default;
};
Ids idsAt(const Maps& maps, int x, int y) {
    return {maps.ids.at(x, y, 0), maps.ids.at(x, y, 1), maps.ids.at(x, y, 2), maps.ids.at(x, y, 3)};
}

unsigned typesIn(const Maps& maps) {
    unsigned all = 0;
    for (const std::uint16_t t : maps.types.pixels()) all |= t;
    return all;
}

TEST_P(LinesOfScenes, ofACubeAreOutlineAndCrease) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const bool orthographic : {false, true}) {
        const Maps maps = renderer().render(scene, frameCamera(scene, threeQuarters(orthographic), pictureSize),
                                            linesOf(pictureSize));
        EXPECT_EQ(typesIn(maps), outline | crease);
    }
}

TEST_P(LinesOfScenes, ofASheetsBorderAreBoundaries) {
    const Mesh sheet = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    const Maps alone = renderer().render(scenes::sceneOf(sheet), flatCamera(), linesOf(square));
    EXPECT_THAT(alone.types.pixels(), Each(testing::AnyOf(0, static_cast<int>(outline | boundary))));
    // 64 pixels along each side, corners once: the marks are on the sheet's side.
    EXPECT_EQ(countMarked(alone.types), 4 * 64 - 4);
    EXPECT_EQ(alone.types.at(32, 64), outline | boundary);
    EXPECT_EQ(alone.types.at(31, 64), 0);
    // Over another sheet of the same node it hides part of that.
    Mesh two = sheet;
    for (const glm::vec3 p : sheet.positions) two.positions.push_back(0.5F * p + glm::vec3{0, 0, 1});
    for (const std::uint32_t i : sheet.indices) two.indices.push_back(4 + i);
    const Maps over = renderer().render(scenes::sceneOf(two), flatCamera(), linesOf(square));
    EXPECT_EQ(over.types.at(48, 64), occlusion | boundary);
    EXPECT_EQ(over.types.at(47, 64), 0);
    EXPECT_EQ(over.types.at(32, 64), outline | boundary);
}

TEST_P(LinesOfScenes, ofBoxesDistinguishOcclusionFromIntersectionAndNodesFromNodes) {
    // One box in front of another, and one that runs half into the first.
    const Scene scene = scenes::sceneOf(
        {{scenes::box({1, 1, 1}), scenes::translation({0, 0, 2})},
         {scenes::box({2, 2, 1}), scenes::translation({0.5, 0, 0})},
         {scenes::box({1, 0.5, 0.5}), scenes::translation({-0.5, 0, 2.25}) * scenes::rotation(30, {0, 1, 0})}});
    const Maps maps = renderer().render(scene, flatCamera(), linesOf(square, {Map::Types, Map::Ids}));
    // The first box's right side, at x = 0.5, pixel 80, hides the second.
    EXPECT_EQ(maps.types.at(79, 70), occlusion | object);
    EXPECT_EQ(idsAt(maps, 79, 70).node, 1U);
    EXPECT_EQ(idsAt(maps, 80, 70).node, 2U);
    EXPECT_EQ(idsAt(maps, 79, 70).across, idsAt(maps, 80, 70).patch);
    EXPECT_EQ(idsAt(maps, 80, 70).across, idsAt(maps, 79, 70).patch);
    EXPECT_NE(idsAt(maps, 80, 70).patch, idsAt(maps, 79, 70).patch);
    // The third, turned, dips into the first one's front.
    int intersections = 0;
    for (int y = 0; y < square.height; ++y) {
        for (int x = 0; x < square.width; ++x) {
            if ((maps.types.at(x, y) & intersection) == 0) continue;
            ++intersections;
            EXPECT_EQ(maps.types.at(x, y) & object, object);
            EXPECT_THAT(idsAt(maps, x, y).node, testing::AnyOf(1U, 3U));
        }
    }
    EXPECT_GE(intersections, 10);
}

TEST_P(LinesOfScenes, haveTheIdsOfBothSides) {
    // Two quads in one mesh of two materials that meet in a ridge, and a third behind, of another node without
    // material.
    Mesh roof;
    roof.positions = {{-1, -1, 0}, {0, -1, 1}, {0, 1, 1}, {-1, 1, 0}, {1, -1, 0}, {1, 1, 0}};
    roof.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
    roof.materials = {5, 5, 7, 7};
    const Mesh wall = scenes::quad({-1.5, -1.5, -2}, {1.5, -1.5, -2}, {1.5, 1.5, -2}, {-1.5, 1.5, -2});
    const Scene scene = scenes::sceneOf({{roof, glm::dmat4{1.0}}, {wall, glm::dmat4{1.0}}});
    for (const int supersampling : {1, 2}) {
        Settings settings = linesOf(square, {Map::Types, Map::Ids});
        settings.picture.supersampling = supersampling;
        const Maps maps = renderer().render(scene, flatCamera(), settings);
        EXPECT_EQ(idsAt(maps, 40, 64), (Ids{1, 0, 1, 5})) << "left";
        EXPECT_EQ(idsAt(maps, 90, 64), (Ids{2, 0, 1, 7})) << "right";
        EXPECT_EQ(idsAt(maps, 63, 64), (Ids{1, 2, 1, 5})) << "left of the ridge";
        EXPECT_EQ(idsAt(maps, 64, 64), (Ids{2, 1, 1, 7})) << "right of the ridge";
        EXPECT_EQ(idsAt(maps, 95, 64), (Ids{2, 3, 1, 7})) << "before the wall";
        EXPECT_EQ(idsAt(maps, 96, 64).node, 2U) << "on the wall";
        EXPECT_EQ(idsAt(maps, 108, 64), (Ids{3, 0, 2, 0})) << "on the wall";
        EXPECT_EQ(idsAt(maps, 5, 5), (Ids{0, 0, 0, 0})) << "background";
        EXPECT_EQ(maps.types.at(63, 64) | maps.types.at(64, 64), crease);
        EXPECT_EQ(maps.types.at(95, 64), occlusion | boundary | object);
    }
}

TEST_P(LinesOfScenes, areDrawnAsAskedAndCountedWhetherDrawnOrNot) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Camera camera = frameCamera(scene, threeQuarters(false), pictureSize);
    Settings settings = linesOf(pictureSize, {Map::Types, Map::Edges});
    const Maps all = renderer().render(scene, camera, settings);
    settings.picture.lines = LineType::Crease;
    const Maps creases = renderer().render(scene, camera, settings);
    settings.picture.lines = LineType::Outline;
    const Maps outlines = renderer().render(scene, camera, settings);
    settings.picture.lines = {};
    const Maps none = renderer().render(scene, camera, settings);
    EXPECT_EQ(creases.types, all.types);
    EXPECT_THAT(none.picture.pixels(), Each(255));
    EXPECT_THAT(none.edges.pixels(), Each(0));
    int drawn = 0;
    for (std::size_t i = 0; i < all.types.pixels().size(); ++i) {
        ASSERT_EQ(all.edges.pixels()[i] != 0, all.types.pixels()[i] != 0);
        ASSERT_EQ(creases.edges.pixels()[i] != 0, (all.types.pixels()[i] & crease) != 0);
        ASSERT_EQ(outlines.edges.pixels()[i] != 0, (all.types.pixels()[i] & outline) != 0);
        // Together they are the whole, but where a crease runs into the outline.
        drawn += std::min(creases.picture.pixels()[i], outlines.picture.pixels()[i]) == all.picture.pixels()[i] ? 0 : 1;
    }
    EXPECT_LE(drawn, 7 * 16);  // each of the cube's seven corners in view: a cell and the ink about it
    EXPECT_LT(countMarked(creases.edges), countMarked(outlines.edges));
}

TEST_P(LinesOfScenes, agreeWhateverTheSupersampling) {
    for (const char* asset : {"gear.glb", "bracket.glb"}) {
        const Scene scene = loadScene(assets + asset);
        const Camera camera = frameCamera(scene, threeQuarters(false), pictureSize);
        Settings settings = linesOf(pictureSize);
        std::vector<Maps> maps;
        for (const int samples : {1, 2, 4}) {
            settings.picture.supersampling = samples;
            maps.push_back(renderer().render(scene, camera, settings));
        }
        const auto ink = [](const Maps& m) {
            double sum = 0.0;
            for (const std::uint8_t p : m.picture.pixels()) sum += 255.0 - p;
            return sum;
        };
        for (std::size_t i = 1; i < maps.size(); ++i) {
            SCOPED_TRACE(testing::Message() << asset << ", " << i);
            ASSERT_EQ(maps[i].picture.size(), pictureSize);
            ASSERT_EQ(maps[i].types.size(), pictureSize);
            // More samples find more where lines stand closer than a pixel, and draw none of the others anew.
            EXPECT_NEAR(ink(maps[i]) / ink(maps[0]), 1.0, 0.06);
            int lost = 0;
            int dark = 0;
            for (std::size_t k = 0; k < maps[0].picture.pixels().size(); ++k) {
                dark += maps[0].picture.pixels()[k] < 64 ? 1 : 0;
                lost += maps[0].picture.pixels()[k] < 64 && maps[i].picture.pixels()[k] > 192 ? 1 : 0;
            }
            EXPECT_GT(dark, 1000);
            EXPECT_LE(lost, dark / 200);
        }
    }
}

// Marked pixels that hang together over sides and corners, each by the larger side of its box.
std::vector<int> extentsOfComponents(const Image<std::uint8_t>& mask) {
    std::vector<int> extents;
    Image<std::uint8_t> left = mask;
    std::vector<glm::ivec2> open;
    for (int y = 0; y < mask.size().height; ++y) {
        for (int x = 0; x < mask.size().width; ++x) {
            if (left.at(x, y) == 0) continue;
            glm::ivec2 low{x, y};
            glm::ivec2 high{x, y};
            open.assign(1, {x, y});
            left.at(x, y) = 0;
            while (!open.empty()) {
                const glm::ivec2 p = open.back();
                open.pop_back();
                low = glm::min(low, p);
                high = glm::max(high, p);
                for (int j = std::max(0, p.y - 1); j <= std::min(mask.size().height - 1, p.y + 1); ++j) {
                    for (int i = std::max(0, p.x - 1); i <= std::min(mask.size().width - 1, p.x + 1); ++i) {
                        if (left.at(i, j) == 0) continue;
                        left.at(i, j) = 0;
                        open.emplace_back(i, j);
                    }
                }
            }
            extents.push_back(std::max(high.x - low.x, high.y - low.y) + 1);
        }
    }
    return extents;
}

TEST_P(LinesOfScenes, ofBodiesLetIntoAnotherAreTheBordersOfEachTop) {
    // Two boxes side by side in a third, all tops in one plane: as many layers on both sides of the joint, other ones.
    const Scene scene = scenes::sceneOf({{scenes::box({3, 3, 1}), glm::dmat4{1.0}},
                                         {scenes::box({0.8, 1, 0.5}), scenes::translation({-0.4, 0, 0.25})},
                                         {scenes::box({0.8, 1, 0.5}), scenes::translation({0.4, 0, 0.25})}});
    const Maps maps = renderer().render(scene, flatCamera(), linesOf(square));
    // 32 pixels per unit: joints at -0.8, 0 and 0.8, the outline at -1.5 and 1.5. A mark stands on either side.
    for (const int y : {50, 64, 77}) {
        std::vector<int> marked;
        for (int x = 0; x < square.width; ++x) {
            if (maps.types.at(x, y) != 0) marked.push_back(x);
        }
        EXPECT_THAT(marked,
                    ElementsAre(16, testing::AnyOf(37, 38), testing::AnyOf(63, 64), testing::AnyOf(89, 90), 111))
            << y;
    }
}

TEST_P(LinesOfScenes, ofSolidsThatTouchInAPlaneDoNotSpeckle) {
    const Scene scene = loadScene(assets + "touching_solids.glb");
    for (int view = 0; view < 24; ++view) {
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = 15.0 * view + 3.7;
        cameraSettings.elevationAngle = -50.0 + 6.0 * view;
        if (view % 2 == 1) cameraSettings.orthographicHeight = 0.0;
        const Maps maps = renderer().render(scene, frameCamera(scene, cameraSettings, pictureSize),
                                            linesOf(pictureSize, {Map::Edges}));
        const std::vector<int> extents = extentsOfComponents(maps.edges);
        EXPECT_THAT(extents, Each(testing::Ge(3))) << "view " << view;
        EXPECT_THAT(extents.size(), testing::AllOf(testing::Ge(1U), testing::Le(12U)))
            << "view " << view;  // a few dozen lines, most of which meet
    }
}

}  // namespace
}  // namespace inkedge::passes
