// All maps of a picture come from one and the same sample of each pixel.
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <inkedge/load_scene.h>

#include "gl/gl_test.h"
#include "mesh/shapes.h"
#include "scenes.h"

namespace inkedge::render {
namespace {

INKEDGE_ON_EACH_BACKEND(MapSamples);

constexpr Size size{192, 144};

Settings settingsOf(Detector detector, int samples) {
    Settings settings;
    settings.picture.size = size;
    settings.picture.supersampling = samples;
    settings.detector.detector = detector;
    settings.maps = {Map::Depth, Map::Normal, Map::Types, Map::Ids};
    return settings;
}

// Pixels at which one map shows the background and another one does not.
int contradictions(const Maps& maps) {
    int count = 0;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool isFar = maps.depth(x, y) == static_cast<float>(maps.camera.far);
            const bool hasNoNormal =
                maps.normal(x, y, 0) == 0 && maps.normal(x, y, 1) == 0 && maps.normal(x, y, 2) == 0;
            const bool hasNoId = maps.ids(x, y, 2) == 0;
            const bool hasNoPatch = maps.ids(x, y, 0) == 0;
            if (isFar != hasNoId || isFar != hasNoNormal || isFar != hasNoPatch) ++count;
        }
    }
    return count;
}

// Whether lines lie where there is nothing.
bool hasLinesOnNothing(const Maps& maps) {
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x)
            if (maps.types(x, y) != 0 && maps.ids(x, y, 2) == 0) return true;
    }
    return false;
}

// Parts of these are seen from their edge, thinner than a pixel: their lines lie between the middles of pixels, too.
const std::set<std::string> withThinParts{"grazing_plane", "primitives", "sheet"};

TEST_P(MapSamples, agreeWhateverTheDetectorAndTheSamples) {
    for (const char* const name :
         {"bracket", "gear", "touching_solids", "boxes", "folded_paper", "grazing_plane", "blob", "sheet", "torus_knot",
          "teapot", "sphere", "cube", "statue", "vase", "primitives", "lantern", "head"}) {
        const Scene scene = loadScene(INKEDGE_SOURCE_DIR "/assets/" + std::string{name} + ".glb");
        const Camera camera = frameCamera(scene, {}, size);
        for (const Detector detector :
             {Detector::Planes, Detector::Classic, Detector::SaitoTakahashi, Detector::None}) {
            const Maps one = renderer().render(scene, camera, settingsOf(detector, 1));
            EXPECT_EQ(contradictions(one), 0) << name << ", detector " << static_cast<int>(detector);
            EXPECT_EQ(hasLinesOnNothing(one), withThinParts.contains(name)) << name;
            for (const int samples : {2, 4}) {
                const Maps maps = renderer().render(scene, camera, settingsOf(detector, samples));
                EXPECT_EQ(contradictions(maps), 0) << name << ", " << samples << " samples";
                EXPECT_EQ(maps.ids, one.ids) << name << ", " << samples << " samples";
                EXPECT_EQ(maps.types, one.types) << name << ", " << samples << " samples";
                EXPECT_EQ(maps.depth, one.depth) << name << ", " << samples << " samples";
            }
        }
    }
}

TEST_P(MapSamples, agreeWithLightsInTwoPasses) {
    const Scene scene = loadScene(INKEDGE_SOURCE_DIR "/assets/gear.glb");
    Settings settings = settingsOf(Detector::Classic, 2);
    settings.detector.normalLights = NormalLights::TwoPass;
    EXPECT_EQ(contradictions(renderer().render(scene, frameCamera(scene, {}, size), settings)), 0);
}

TEST_P(MapSamples, normalsAreThoseOfTheOtherSpaceTurned) {
    const Scene scene = loadScene(INKEDGE_SOURCE_DIR "/assets/teapot.glb");
    const Camera camera = frameCamera(scene, {}, size);
    const glm::dmat3 view{camera.view};
    for (const LightSpace lights : {LightSpace::Camera, LightSpace::World}) {
        Settings settings = settingsOf(Detector::Classic, 1);
        settings.detector.lightSpace = lights;
        const Maps seen = renderer().render(scene, camera, settings);
        settings.normalSpace = NormalSpace::World;
        const Maps world = renderer().render(scene, camera, settings);
        for (int y = 0; y < size.height; ++y) {
            for (int x = 0; x < size.width; ++x) {
                const auto at = [&](const Maps& maps) {
                    return glm::dvec3{maps.normal(x, y, 0), maps.normal(x, y, 1), maps.normal(x, y, 2)};
                };
                // floats of unit length, turned once
                ASSERT_LT(glm::length(view * at(world) - at(seen)), 1e-6) << x << ", " << y;
                if (at(seen) != glm::dvec3{0.0}) {
                    ASSERT_GT(at(seen).z, -0.2) << "turned to the eye";
                }
            }
        }
    }
}

// Pixels that show a surface whose depth or normal none of the scene has.
int impossible(const Maps& maps) {
    int count = 0;
    for (int y = 0; y < maps.depth.size().height; ++y) {
        for (int x = 0; x < maps.depth.size().width; ++x) {
            if (maps.ids(x, y, 2) == 0) continue;
            const double depth = maps.depth(x, y);
            const glm::dvec3 normal{maps.normal(x, y, 0), maps.normal(x, y, 1), maps.normal(x, y, 2)};
            const bool isUnit = std::abs(glm::length(normal) - 1.0) < 1e-3;  // of floats
            if (!(depth >= maps.camera.near && depth <= maps.camera.far && isUnit)) ++count;
        }
    }
    return count;
}

// Its sides are long slivers, some of them seen edge-on in each view along an axis, a diagonal or a dimetric direction.
TEST_P(MapSamples, ofFacesSeenEdgeOnAreOnTheSurface) {
    Settings settings = settingsOf(Detector::Planes, 1);
    settings.picture.size = {500, 500};
    for (const int sides : {96, 360}) {
        for (const double turn : {0.0, 45.0, 19.4712206}) {
            const Scene scene = scenes::sceneOf(mesh::prism(sides), scenes::rotation(turn, {0, 0, 1}));
            for (const double azimuth : {0.0, 45.0, 90.0}) {
                for (const double elevation : {0.0, 19.4712206, 35.2643897, 90.0}) {
                    CameraSettings view;
                    view.azimuthAngle = azimuth;
                    view.elevationAngle = elevation;
                    view.orthographicHeight = 0.0;
                    for (const Detector detector : {Detector::Planes, Detector::Classic}) {
                        settings.detector.detector = detector;
                        const Camera camera = frameCamera(scene, view, settings.picture.size);
                        EXPECT_EQ(impossible(renderer().render(scene, camera, settings)), 0)
                            << sides << " sides, turned by " << turn << ", azimuth " << azimuth << ", elevation "
                            << elevation;
                    }
                }
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::render
