#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <thread>

#include <gmock/gmock.h>
#include <malloc.h>
#include <unistd.h>

#include "base/expect_error.h"
#include "gl/framed_pictures.h"
#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::render {
namespace {

using gl_test::classic;
using gl_test::classicMaps;
using namespace framed_pictures;
using testing::Each;
using testing::HasSubstr;
using testing::StrEq;

INKEDGE_ON_EACH_BACKEND(Rendering);

TEST_P(Rendering, saysWhatDrewThePicture) {
    const Maps maps = renderFramed(renderer(), scenes::sceneOf(scenes::cube()), {32, 32});
    EXPECT_EQ(maps.backend.backend, gl_test::backendName(GetParam()));
    EXPECT_THAT(maps.backend.platform, testing::AnyOf(HasSubstr("device "), StrEq("surfaceless"), StrEq("osmesa")));
    for (const std::string& text : {maps.backend.vendor, maps.backend.renderer, maps.backend.version}) {
        EXPECT_THAT(text, testing::Not(testing::IsEmpty()));
    }
    std::vector<std::string> stages;
    for (const StageTime& time : maps.times) {
        stages.push_back(time.stage);
        EXPECT_GE(time.milliseconds, 0.0);
    }
    EXPECT_THAT(stages, testing::IsSupersetOf({"upload", "surface", "edges", "composite", "read-back"}));
}

TEST_P(Rendering, fitsTheNearAndFarPlanesOfACameraThatHasNone) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    RenderSettings settings;
    settings.picture.size = {64, 48};
    settings.maps = {Map::Depth};
    const Camera framed = frameCamera(scene, {}, settings.picture.size);
    Camera without = framed;
    without.near = without.far = 0.0;
    const Maps maps = renderer().render(scene, without, settings);
    EXPECT_EQ(maps.camera.near, framed.near);
    EXPECT_EQ(maps.camera.far, framed.far);
    EXPECT_EQ(maps.depth, renderer().render(scene, framed, settings).depth);
    without.near = 1.0;
    without.far = 0.5;
    EXPECT_THROW((void)renderer().render(scene, without, settings), Error);
}

TEST_P(Rendering, betweenPixelsNeedsNoNormalsOfVertices) {
    LoadSettings load;
    load.completeNormals = false;
    const Scene without = scenes::sceneOf({{scenes::cube(), glm::dmat4{1.0}}}, load);
    const Scene with = scenes::sceneOf(scenes::cube());
    EXPECT_THAT(without.meshes().front().normals, Each(glm::vec3{0.0F}));
    RenderSettings settings;
    settings.picture.size = {64, 48};
    settings.maps = {Map::Depth, Map::Ids, Map::Types};
    const Camera camera = frameCamera(with, {}, settings.picture.size);
    const Maps maps = renderer().render(without, camera, settings);
    const Maps expected = renderer().render(with, camera, settings);
    EXPECT_TRUE(std::ranges::equal(maps.picture.pixels(), expected.picture.pixels()));
    EXPECT_TRUE(std::ranges::equal(maps.depth.pixels(), expected.depth.pixels()));
    EXPECT_TRUE(std::ranges::equal(maps.types.pixels(), expected.types.pixels()));
    settings.maps = {Map::Normal};
    EXPECT_THROW((void)renderer().render(without, camera, settings), Error);
    settings.maps = {};
    EXPECT_THROW((void)renderer().lines(without, camera, settings), Error) << "of the mesh";
    settings.lines.from = LinesFrom::Image;
    EXPECT_NO_THROW((void)renderer().lines(without, camera, settings));
}

TEST_P(Rendering, givesOnlyTheMapsAskedFor) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Camera camera = frameCamera(scene, {}, {20, 10});
    const Maps none = renderer().render(scene, camera, classic({20, 10}));
    EXPECT_EQ(none.picture.size(), (Size{20, 10}));
    EXPECT_TRUE(none.depth.empty() && none.windowDepth.empty() && none.normal.empty() && none.depthMagnitude.empty() &&
                none.normalMagnitude.empty() && none.depthEdges.empty() && none.normalEdges.empty() &&
                none.edges.empty());

    const Maps depth = renderer().render(scene, camera, classic({20, 10}, {Map::Depth}));
    EXPECT_EQ(depth.depth.size(), (Size{20, 10}));
    EXPECT_EQ(depth.windowDepth.size(), (Size{20, 10}));
    EXPECT_TRUE(depth.normal.empty() && depth.edges.empty() && depth.depthMagnitude.empty());

    const Maps edges = renderer().render(scene, camera, classic({20, 10}, {Map::Edges, Map::NormalEdges}));
    EXPECT_EQ(edges.edges.size(), (Size{20, 10}));
    EXPECT_EQ(edges.normalEdges.size(), (Size{20, 10}));
    EXPECT_EQ(edges.normalMagnitude.size(), (Size{20, 10}));
    EXPECT_TRUE(edges.depth.empty() && edges.depthEdges.empty() && edges.depthMagnitude.empty());
    EXPECT_EQ(edges.picture, none.picture) << "the maps asked for change the picture";
}

TEST_P(Rendering, putsRowZeroAtTheTop) {
    // A triangle in the upper left half of the picture, wide at the top.
    Mesh mesh = scenes::quad({-1, 1, 0}, {-1, 0, 0}, {1, 1, 0}, {1, 1, 0});
    mesh.indices = {0, 1, 2};
    const Maps maps = renderer().render(scenes::sceneOf(mesh), squareCamera(), classic({16, 16}, {Map::Depth}));
    const auto drawn = [&](int x, int y) { return maps.depth.at(x, y) < 8.9F; };
    EXPECT_TRUE(drawn(0, 0));
    EXPECT_TRUE(drawn(13, 0));
    EXPECT_TRUE(drawn(0, 6));
    EXPECT_FALSE(drawn(13, 6));
    for (int y = 8; y < 16; ++y) {
        for (int x = 0; x < 16; ++x) EXPECT_FALSE(drawn(x, y));
    }
    for (int y = 0; y < 8; ++y) {
        // Its slanted edge passes (16, 0) and (0, 8); no pixel's centre lies on it.
        for (int x = 0; x < 16; ++x) EXPECT_EQ(drawn(x, y), x + 0.5 < 16.0 - 2.0 * (y + 0.5)) << x << ", " << y;
    }
}

TEST_P(Rendering, takesCounterClockwiseFacesAsFrontAndMirrorsTurnThem) {
    // The normals lean to +X. Seen from the front they stay so; seen from behind they are turned to the eye.
    const glm::vec3 leaning = glm::normalize(glm::vec3{1, 0, 8});  // more than ten degrees would not be believed
    Mesh mesh = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    mesh.normals.assign(4, leaning);
    const auto normal = [&](const glm::dmat4& transform) {
        const Maps maps =
            renderer().render(scenes::sceneOf(mesh, transform), squareCamera(), classic({4, 4}, {Map::Normal}));
        return glm::vec3{maps.normal.at(1, 1, 0), maps.normal.at(1, 1, 1), maps.normal.at(1, 1, 2)};
    };
    const float x = leaning.x;
    constexpr float rounding = 1e-6F;  // a unit vector of floats, normalised once more
    EXPECT_NEAR(normal(glm::dmat4{1.0}).x, x, rounding);
    EXPECT_NEAR(normal(scenes::scaling({-1, 1, 1})).x, -x, rounding) << "mirrored in x: leans the other way, front";
    EXPECT_NEAR(normal(scenes::scaling({1, -1, 1})).x, x, rounding);
    EXPECT_NEAR(normal(scenes::scaling({1, 1, -1})).x, -x, rounding) << "mirrored in depth: its back is seen";
    EXPECT_NEAR(normal(scenes::rotation(180, {0, 1, 0})).x, x, rounding)
        << "turned round: leans to -X, and turned again";
    for (const auto& transform : {glm::dmat4{1.0}, scenes::scaling({-1, 1, 1}), scenes::scaling({1, 1, -1}),
                                  scenes::scaling({-1, -1, -1}), scenes::rotation(180, {0, 1, 0})}) {
        EXPECT_GT(normal(transform).z, 0.0F) << "turned to the side that is seen";
    }
}

TEST_P(Rendering, isTheSameEveryTime) {
    const Scene scene =
        scenes::sceneOf({{scenes::sphere(), glm::dmat4{1.0}}, {scenes::cube(), scenes::translation({1, 1, 0})}});
    expectSame(renderFramed(renderer(), scene, {96, 64}), renderFramed(renderer(), scene, {96, 64}));
}

TEST_P(Rendering, remembersNothingOfTheSceneAndSizeBefore) {
    const Scene first = scenes::sceneOf(scenes::sphere());
    const Scene second = scenes::sceneOf(scenes::cube());
    Renderer fresh{BackendSettings{GetParam(), {}}};
    const Maps alone = renderFramed(fresh, second, {48, 48});
    (void)renderFramed(renderer(), first, {48, 48});
    expectSame(renderFramed(renderer(), second, {48, 48}), alone);
    (void)renderFramed(renderer(), first, {200, 31});
    expectSame(renderFramed(renderer(), second, {48, 48}), alone);
}

TEST_P(Rendering, drawsAnotherSceneThatStandsWhereADeadOneStood) {
    // A scene's data may be allocated where the last one's was; its upload must not pass for the new one's.
    std::optional<Maps> maps;
    for (const double side : {0.5, 1.5}) {
        const Scene scene = scenes::sceneOf(scenes::cube(side));
        maps = renderer().render(scene, squareCamera(), classic({16, 16}, {Map::Depth}));
    }
    const auto drawn = std::ranges::count_if(maps->depth.pixels(), [](float z) { return z < 8.9F; });
    EXPECT_EQ(drawn, 12 * 12);
}

TEST_P(Rendering, refusesSizesThatItCannotDraw) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    constexpr int maxSide = PictureSettings::maxSide;
    for (const Size size : {Size{0, 5}, Size{5, 0}, Size{maxSide + 1, 1}, Size{1, maxSide + 1}}) {
        expectError(Error::Kind::Usage,
                    StrEq("size: expected 1x1 to 32768x32768 pixels, found '" + std::to_string(size.width) + "x" +
                          std::to_string(size.height) + "'"),
                    [&] {
                        (void)renderer().render(scene, frameCamera(scene, {}, {1, 1}), classic(size));
                    });
    }
}

TEST_P(Rendering, refusesSupersamplingThatItCannotDo) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const int samples : {0, -1, 3, 8}) {
        Settings settings = classic({8, 8});
        settings.picture.supersampling = samples;
        expectError(Error::Kind::Usage,
                    StrEq("supersampling: expected 1, 2 or 4, found '" + std::to_string(samples) + "'"), [&] {
                        (void)renderer().render(scene, frameCamera(scene, {}, {8, 8}), settings);
                    });
    }
}

TEST_P(Rendering, refusesTilesThatItCannotDraw) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const int side : {-1, 0, 255, 8193}) {
        Settings settings = classic({8, 8});
        settings.picture.tileSize = side;
        expectError(Error::Kind::Usage,
                    StrEq("tile-size: expected a whole number from 256 to 8192, found '" + std::to_string(side) + "'"),
                    [&] {
                        (void)renderer().render(scene, frameCamera(scene, {}, {8, 8}), settings);
                    });
    }
}

TEST_P(Rendering, drawsTheWidestAndTheTallestPicture) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    constexpr int maxSide = PictureSettings::maxSide;
    for (const Size size : {Size{maxSide, 1}, Size{1, maxSide}}) {
        EXPECT_EQ(renderer().render(scene, frameCamera(scene, {}, size), classic(size)).picture.size(), size);
    }
}

TEST_P(Rendering, refusesAnUnusableCamera) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    std::vector<Camera> cameras(7, frameCamera(scene, {}, {8, 8}));
    cameras[0].near = 0.0;
    cameras[1].near = cameras[1].far;
    cameras[2].viewAngle = 180.0;
    cameras[3].viewAngle = std::nan("");
    cameras[4].far = std::numeric_limits<double>::infinity();
    cameras[5].view[3][0] = std::nan("");
    cameras[6].view[0][0] = std::nan("");
    for (const Camera& camera : cameras) {
        expectError(Error::Kind::Usage, testing::StartsWith("camera: expected a view angle over 0 and under 180"), [&] {
            (void)renderer().render(scene, camera, classic({8, 8}));
        });
    }
}

TEST_P(Rendering, drawsNothingOfWhatIsBehindTheCamera) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    CameraSettings cameraSettings;
    cameraSettings.position = glm::dvec3{0, 0, 9};
    cameraSettings.direction = glm::dvec3{0, 0, 1};
    const Camera camera = frameCamera(scene, cameraSettings, {16, 16});
    const Maps maps = renderer().render(scene, camera, classic({16, 16}, classicMaps));
    EXPECT_THAT(maps.depth.pixels(), Each(static_cast<float>(camera.far)));
    EXPECT_THAT(maps.edges.pixels(), Each(0));
    EXPECT_THAT(maps.picture.pixels(), Each(255));
}

TEST_P(Rendering, ofAnExtremeScaleIsTheSamePicture) {
    const auto draw = [&](double scale) {
        const Scene scene =
            scenes::sceneOf({{scenes::cube(), scenes::scaling(glm::dvec3{scale})},
                             {scenes::sphere(), scenes::scaling(glm::dvec3{scale}) * scenes::translation({2, 1, 0})}});
        return renderFramed(renderer(), scene, {96, 96});
    };
    const Maps plain = draw(1.0);
    for (const double scale : {1e-12, 1e-4, 1e4, 1e12}) {
        const Maps scaled = draw(scale);
        // Bounds, and with them vertices, differ in their last bits, which moves an edge over a pixel centre here and
        // there.
        const auto differ = differing(plain.edges, scaled.edges);
        EXPECT_LE(differ, 4U) << scale;
        EXPECT_NEAR(scaled.depth.at(48, 48) / scale, plain.depth.at(48, 48), 1e-5 * plain.depth.at(48, 48));
    }
}

TEST_P(Rendering, ofAModelFarFromTheOriginIsTheSamePicture) {
    // Eight million units off, floats in world space would be half a unit apart.
    const auto draw = [&](glm::dvec3 offset) {
        const Scene scene = scenes::sceneOf(scenes::cube(), scenes::translation(offset));
        return renderFramed(renderer(), scene, {96, 96});
    };
    EXPECT_EQ(draw({8e6, -8e6, 8e6}).picture.pixels(), draw({0, 0, 0}).picture.pixels());
}

TEST_P(Rendering, goesOnInARendererThatWasMoved) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    Renderer first{BackendSettings{GetParam(), {}}};
    const Maps before = renderFramed(first, scene, {32, 32});
    Renderer second{std::move(first)};
    expectSame(renderFramed(second, scene, {32, 32}), before);
    Renderer third{BackendSettings{GetParam(), {}}};
    third = std::move(second);
    expectSame(renderFramed(third, scene, {32, 32}), before);
}

TEST_P(Rendering, worksInSeveralRenderersSideBySide) {
    const Scene one = scenes::sceneOf(scenes::cube());
    const Scene other = scenes::sceneOf(scenes::sphere());
    Renderer a{BackendSettings{GetParam(), {}}};
    const Maps oneAlone = renderFramed(a, one, {64, 64});
    {
        Renderer b{BackendSettings{GetParam(), {}}};
        const Maps otherAlone = renderFramed(b, other, {40, 64});
        for (int i = 0; i < 3; ++i) {
            expectSame(renderFramed(a, one, {64, 64}), oneAlone);
            expectSame(renderFramed(b, other, {40, 64}), otherAlone);
        }
    }
    expectSame(renderFramed(a, one, {64, 64}), oneAlone);  // after the other's end
}

TEST_P(Rendering, worksOnAnyThreadOneAtATime) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Maps here = renderFramed(renderer(), scene, {32, 32});
    std::optional<Maps> there;
    std::thread{[&] { there = renderFramed(renderer(), scene, {32, 32}); }}.join();
    expectSame(*there, here);
    expectSame(renderFramed(renderer(), scene, {32, 32}), here);
}

TEST_P(Rendering, worksOnSeveralThreadsWithARendererEach) {
    const Scene scene = scenes::sceneOf(scenes::sphere());
    const Maps alone = renderFramed(renderer(), scene, {48, 48});
    std::vector<std::optional<Maps>> results(3);
    std::vector<std::thread> threads;
    for (auto& result : results) {
        threads.emplace_back([&] {
            Renderer own{BackendSettings{GetParam(), {}}};
            for (int i = 0; i < 3; ++i) result = renderFramed(own, scene, {48, 48});
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const auto& result : results) expectSame(*result, alone);
}

std::size_t residentBytes() {
    std::ifstream statm{"/proc/self/statm"};
    std::size_t total = 0;
    std::size_t resident = 0;
    statm >> total >> resident;
    return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST_P(Rendering, doesNotGrowWithTheNumberOfPictures) {
    const std::vector scenes{scenes::sceneOf(scenes::cube()), scenes::sceneOf(scenes::sphere(1.0, 128)),
                             scenes::sceneOf(scenes::sphere(1.0, 96))};
    const std::vector<Size> sizes{{512, 512}, {256, 384}, {128, 128}, {300, 512}};
    const auto draw = [&](std::size_t i) {
        (void)renderFramed(renderer(), scenes[i % scenes.size()], sizes[i % sizes.size()]);
    };
    for (std::size_t i = 0; i < 24; ++i) draw(i);  // fills caches: compiled shader variants, the allocator's free lists
    // A leak grows in every stretch; the allocator, which keeps what it was given back, does so in some.
    std::size_t minGrowth = std::numeric_limits<std::size_t>::max();
    for (int stretch = 0; stretch < 4; ++stretch) {
        malloc_trim(0);
        const std::size_t before = residentBytes();
        for (std::size_t i = 0; i < 50; ++i) draw(i);
        malloc_trim(0);
        const std::size_t after = residentBytes();
        minGrowth = std::min(minGrowth, after > before ? after - before : 0);
    }
    // The smallest texture, 8 bits a pixel at the mean of these sizes, has 133 kB, and the smaller sphere's upload 220
    // kB: a leak of one of them a picture comes to 6 MB in a stretch.
    EXPECT_LT(minGrowth, 3'000'000U);
}

}  // namespace
}  // namespace inkedge::render
