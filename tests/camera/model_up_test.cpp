// Which way is up of a model, where its front looks to, and what turns about it.
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/camera.h>

#include "camera/framed_scenes.h"
#include "scenes.h"

namespace inkedge::camera {
namespace {

using namespace framed_scenes;

// The skew scene in another world, whose up is this.
Scene turnedScene(glm::dvec3 up) {
    LoadSettings settings;
    settings.up = up;
    return scenes::sceneOf({{scenes::box({4, 1, 2}), scenes::translation({3, 1, -2})},
                            {scenes::cube(0.5), scenes::translation({0, 3, 1})}},
                           settings);
}

struct Upright {
    glm::dvec3 up;
    glm::dvec3 front;
    glm::dvec3 right;
};

TEST(Scene, frontAndRightFollowUp) {
    const std::vector<Upright> all{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}},  {{0, 0, 1}, {0, -1, 0}, {1, 0, 0}},
                                   {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}, {{1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                   {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, {{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}}};
    for (const auto& [up, front, right] : all) {
        const Scene scene = turnedScene(7.5 * up);
        EXPECT_EQ(scene.up(), up);
        EXPECT_EQ(scene.front(), front);
        expectNear(glm::cross(scene.up(), scene.front()), right);
    }
    const Scene tilted = turnedScene({1, 2, -2});
    expectNear(tilted.up(), glm::dvec3{1, 2, -2} / 3.0);
    EXPECT_NEAR(glm::dot(tilted.up(), tilted.front()), 0.0, exact);
    EXPECT_NEAR(glm::length(tilted.front()), 1.0, exact);
    Scene::Data data;
    data.meshes.push_back(scenes::cube());
    data.instances.push_back({"cube", 0});
    data.source.up = {0, 0, 1};
    EXPECT_EQ(Scene{data}.up(), glm::dvec3(0, 0, 1)) << "the format's";
    LoadSettings settings;
    settings.up = glm::dvec3{0, 2, 0};
    EXPECT_EQ(Scene(data, settings).up(), glm::dvec3(0, 1, 0)) << "the settings' wins";
}

TEST(FrameCamera, everythingTurnsAboutTheModelsUp) {
    const Scene scene = turnedScene({0, 0, 1});
    const auto seen = [&](double azimuth, double elevation) {
        CameraSettings wanted;
        wanted.azimuthAngle = azimuth;
        wanted.elevationAngle = elevation;
        return frameCamera(scene, wanted, square);
    };
    expectNear(-forward(seen(0, 0)), {0, -1, 0});
    expectNear(-forward(seen(90, 0)), {1, 0, 0});
    expectNear(-forward(seen(180, 0)), {0, 1, 0});
    expectNear(-forward(seen(0, 45)), glm::dvec3{0, -1, 1} * std::sqrt(0.5));
    for (const double azimuth : {0.0, 40.0, 200.0}) {
        expectNear(worldAxis(seen(azimuth, 20), 0) * glm::dvec3(0, 0, 1), glm::dvec3{0.0});  // the horizon is level
        EXPECT_GT(worldAxis(seen(azimuth, 20), 1).z, 0.0) << "it stands upright";
    }
    const Camera plain = frameCamera(scene, {}, square);
    EXPECT_NEAR(forward(plain).z, -std::sin(glm::radians(20.0)), exact);
    CameraSettings rolled;
    rolled.viewUp = glm::dvec3{1, 0, 0};
    const Camera camera = frameCamera(scene, rolled, square);
    expectNear(forward(camera), forward(plain));
    EXPECT_GT(worldAxis(camera, 1).x, 0.5) << "camera-view-up rolls the camera and turns nothing else";
}

TEST(FrameCamera, anElevationOf90IsNoError) {
    for (const glm::dvec3 up : {glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}, glm::dvec3{1, 2, 3}}) {
        for (const double elevation : {90.0, -90.0}) {
            for (const double azimuth : {0.0, 30.0}) {
                const Scene scene = turnedScene(up);
                CameraSettings wanted;
                wanted.elevationAngle = elevation;
                wanted.azimuthAngle = azimuth;
                const Camera plain = frameCamera(scene, wanted, square);
                expectNear(forward(plain), -std::copysign(1.0, elevation) * scene.up());
                wanted.viewUp = up;
                expectNear(worldAxis(frameCamera(scene, wanted, square), 1), worldAxis(plain, 1));
                wanted.elevationAngle = std::copysign(89.9, elevation);
                const Camera tilted = frameCamera(scene, wanted, square);
                EXPECT_GT(glm::dot(worldAxis(tilted, 1), worldAxis(plain, 1)), 0.999)
                    << "it is seen as if tilted a bit";
            }
        }
    }
}

TEST(FrameCamera, namedViewsAreThoseOfTechnicalDrawings) {
    struct Expected {
        NamedView view;
        glm::dvec3 from;
        glm::dvec3 up;  // in the picture
    };
    // Along the model's own axes: right, up, front.
    const std::vector<Expected> all{
        {NamedView::Front, {0, 0, 1}, {0, 1, 0}}, {NamedView::Back, {0, 0, -1}, {0, 1, 0}},
        {NamedView::Left, {-1, 0, 0}, {0, 1, 0}}, {NamedView::Right, {1, 0, 0}, {0, 1, 0}},
        {NamedView::Top, {0, 1, 0}, {0, 0, -1}},  {NamedView::Bottom, {0, -1, 0}, {0, 0, 1}}};
    for (const glm::dvec3 up : {glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}}) {
        const Scene scene = turnedScene(up);
        const auto world = [&](glm::dvec3 v) {
            return v.x * glm::cross(scene.up(), scene.front()) + v.y * scene.up() + v.z * scene.front();
        };
        for (const auto& [view, from, upwards] : all) {
            CameraSettings wanted;
            wanted.view = view;
            const Camera camera = frameCamera(scene, wanted, square);
            EXPECT_TRUE(camera.orthographic());
            EXPECT_EQ(-forward(camera), world(from)) << "exactly: edges seen edge-on stay so";
            expectNear(worldAxis(camera, 1), world(upwards));
            expectFramed(scene, camera, square);
        }
        const auto scalesOf = [&](NamedView view) {
            CameraSettings wanted;
            wanted.view = view;
            const Camera camera = frameCamera(scene, wanted, square);
            std::vector<double> scales;  // of width, height and depth
            for (const glm::dvec3 axis : {glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}})
                scales.push_back(glm::length(glm::dvec2{glm::dmat3{camera.view} * world(axis)}));
            EXPECT_GT(glm::dot(-forward(camera), world({1, 0, 0})), 0.0) << "from the right";
            EXPECT_GT(glm::dot(-forward(camera), world({0, 1, 0})), 0.0) << "from above";
            return scales;
        };
        const std::vector<double> iso = scalesOf(NamedView::Iso);
        EXPECT_NEAR(iso[0], iso[1], exact);
        EXPECT_NEAR(iso[0], iso[2], exact);
        const std::vector<double> dimetric = scalesOf(NamedView::Dimetric);
        EXPECT_NEAR(dimetric[0], dimetric[1], exact);
        EXPECT_NEAR(dimetric[0], 2.0 * dimetric[2], exact);
    }
    CameraSettings wanted;
    wanted.view = NamedView::Front;
    wanted.viewAngle = 20.0;
    EXPECT_FALSE(frameCamera(skewScene(), wanted, square).orthographic());
    wanted.viewAngle.reset();
    wanted.orthographicHeight = 8.0;
    EXPECT_EQ(frameCamera(skewScene(), wanted, square).orthographicHeight, 8.0);
}

}  // namespace
}  // namespace inkedge::camera
