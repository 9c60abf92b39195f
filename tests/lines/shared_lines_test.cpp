// What is prepared of a scene for its lines is shared by all who look for them.
#include <algorithm>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <inkedge/load_scene.h>

#include "lines/object_lines.h"
#include "scene/prepared.h"
#include "scenes.h"

namespace inkedge::lines {
namespace {

Settings objectSettings() {
    Settings settings;
    settings.picture.size = {120, 90};
    settings.lines.from = LinesFrom::Object;
    return settings;
}

Camera cameraAt(const Scene& scene, double azimuth) {
    CameraSettings camera;
    camera.azimuthAngle = azimuth;
    return frameCamera(scene, camera, {120, 90});
}

bool sameLines(const Lines& a, const Lines& b) {
    const auto samePoint = [](const LinePoint& p, const LinePoint& q) { return p.position == q.position; };
    return std::ranges::equal(a.lines, b.lines, [&](const Line& l, const Line& m) {
        return l.type == m.type && l.visible == m.visible && std::ranges::equal(l.points, m.points, samePoint);
    });
}

Scene knot() { return loadScene(INKEDGE_SOURCE_DIR "/assets/torus_knot.glb"); }

TEST(SharedLines, arePreparedOnceForCopiesOfAScene) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Scene other = scenes::sceneOf(scenes::cube());
    const Scene copy = scene;
    const scene::SharedOnce& shared = *preparedOf(scene)->lines;
    const ObjectLines first{scene};
    const ObjectLines second{copy};
    const ObjectLines ofOther{other};
    EXPECT_EQ(shared.holders(), 2);
    EXPECT_EQ(preparedOf(other)->lines->holders(), 1);
}

TEST(SharedLines, holdNoSceneOnceNobodyHoldsThem) {
    std::weak_ptr<const void> identity;
    {
        const Scene scene = scenes::sceneOf(scenes::cube());
        identity = scene::identityOf(scene);
        {
            const ObjectLines first{scene};
            const ObjectLines second{scene};
        }
        EXPECT_EQ(preparedOf(scene)->lines->holders(), 0);
        EXPECT_EQ(identity.use_count(), 1);
    }
    EXPECT_TRUE(identity.expired());
}

TEST(SharedLines, outliveTheScene) {
    std::optional<Scene> scene = scenes::sceneOf(scenes::cube());
    const Camera camera = cameraAt(*scene, 30.0);
    const ObjectLines lines{*scene};
    const Lines before = lines.find(camera, objectSettings());
    scene.reset();
    EXPECT_FALSE(before.lines.empty());
    EXPECT_TRUE(sameLines(before, lines.find(camera, objectSettings())));
}

TEST(SharedLines, areFoundAlikeByManyThreads) {
    const Scene scene = knot();
    Settings settings = objectSettings();
    settings.picture.lines = standardLineTypes;
    std::vector<Lines> alone;
    for (int i = 0; i < 4; ++i) alone.push_back(ObjectLines{scene}.find(cameraAt(scene, 90.0 * i), settings));
    std::vector<Lines> together(alone.size());
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 0; i < together.size(); ++i) {
            threads.emplace_back([&, i] {
                const ObjectLines mine{scene};
                together[i] = mine.find(cameraAt(scene, 90.0 * static_cast<double>(i)), settings);
            });
        }
    }
    for (std::size_t i = 0; i < together.size(); ++i) {
        EXPECT_FALSE(alone[i].lines.empty());
        EXPECT_TRUE(sameLines(alone[i], together[i])) << i;
    }
}

// The search at random goes on from the views before: of its own object, whatever others of the scene look at.
TEST(SharedLines, rememberTheirOwnViewsOnly) {
    const Scene scene = scenes::sceneOf(scenes::sphere(1.0, 128));
    Settings settings = objectSettings();
    settings.lines.contour = Contour::Mesh;
    settings.lines.contourFinder = ContourFinder::Random;
    const auto views = [&](const ObjectLines& lines) {
        std::vector<Lines> found;
        for (const double azimuth : {0.0, 10.0, 20.0}) found.push_back(lines.find(cameraAt(scene, azimuth), settings));
        return found;
    };
    const std::vector<Lines> alone = views(ObjectLines{scene});
    const ObjectLines mine{scene};
    const ObjectLines another{scene};
    for (const double azimuth : {200.0, 100.0}) (void)another.find(cameraAt(scene, azimuth), settings);
    const std::vector<Lines> beside = views(mine);
    for (std::size_t i = 0; i < alone.size(); ++i) EXPECT_TRUE(sameLines(alone[i], beside[i])) << i;
}

}  // namespace
}  // namespace inkedge::lines
