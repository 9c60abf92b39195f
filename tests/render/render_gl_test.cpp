// Renderer::lines() as a library's user calls it.
#include <inkedge/load_scene.h>
#include <inkedge/read_lines.h>
#include <inkedge/renderer.h>
#include <inkedge/write.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <thread>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/expect_error.h"
#include "gl/gl_test.h"
#include "mesh/curved_shapes.h"
#include "scenes.h"

namespace inkedge::render {
namespace {

INKEDGE_ON_EACH_BACKEND(RendererLines);

using testing::HasSubstr;

constexpr Size size{200, 150};

Settings settingsOf(LinesFrom from) {
    Settings settings;
    settings.picture.size = size;
    settings.lines.from = from;
    settings.lines.hidden = HiddenLines::Solid;
    return settings;
}

const std::vector<Settings>& everyWay() {
    static const std::vector<Settings> all{settingsOf(LinesFrom::Auto), settingsOf(LinesFrom::Object),
                                           settingsOf(LinesFrom::Image)};
    return all;
}

Lines linesOf(Renderer& renderer, const Scene& scene, const Settings& settings) {
    return renderer.lines(scene, frameCamera(scene, {}, size), settings);
}

void expectSame(const Lines& a, const Lines& b) {
    ASSERT_EQ(a.lines.size(), b.lines.size());
    for (std::size_t i = 0; i < a.lines.size(); ++i) {
        const Line& one = a.lines[i];
        const Line& other = b.lines[i];
        EXPECT_EQ(one.type, other.type);
        EXPECT_EQ(one.visible, other.visible);
        ASSERT_EQ(one.points.size(), other.points.size());
        for (std::size_t k = 0; k < one.points.size(); ++k) EXPECT_EQ(one.points[k].pixel, other.points[k].pixel);
    }
}

TEST_P(RendererLines, warnOfIsolinesWithoutTextureCoordinates) {
    const std::vector<std::string> expected{"has no texture coordinates: no isolines are drawn"};
    const Scene without = scenes::sceneOf(scenes::cube());
    Mesh mapped = scenes::cube();
    mapped.textureCoordinates.resize(mapped.positions.size());
    const Scene with = scenes::sceneOf(mapped);
    const Camera camera = frameCamera(without, {}, size);
    for (Settings settings : everyWay()) {
        EXPECT_TRUE(linesOf(renderer(), without, settings).warnings.empty());
        settings.lines.isolines = {4, 0};
        settings.picture.lines |= LineType::Isoparametric;
        EXPECT_EQ(linesOf(renderer(), without, settings).warnings, expected);
        EXPECT_EQ(renderer().render(without, camera, settings).warnings, expected);
        EXPECT_EQ(renderWarnings(without, settings), expected);
        EXPECT_TRUE(linesOf(renderer(), with, settings).warnings.empty());
        EXPECT_TRUE(renderer().render(with, camera, settings).warnings.empty());
    }
}

TEST_P(RendererLines, haveThoseOfTheFileInBothSources) {
    Mesh mesh;
    mesh.lines = {{-1, 0, 0}, {1, 0.5F, 0}};
    for (const bool alone : {true, false}) {
        std::vector<std::pair<Mesh, glm::dmat4>> instances{{mesh, glm::dmat4{1.0}}};
        if (!alone) instances.emplace_back(scenes::cube(0.5), glm::dmat4{1.0});
        const Scene scene = scenes::sceneOf(instances);
        std::vector<double> lengths;
        for (const LinesFrom from : {LinesFrom::Object, LinesFrom::Image}) {
            Settings settings = settingsOf(from);
            settings.lines.hidden = HiddenLines::None;
            double sum = 0.0;
            for (const Line& line : linesOf(renderer(), scene, settings).lines)
                if (line.type == LineType::Marked) sum += glm::distance(line.points[0].pixel, line.points[1].pixel);
            EXPECT_GT(sum, 20.0);
            lengths.push_back(sum);
            const auto picture = [&](LineTypes types) {
                settings.picture.lines = types;
                return renderer().render(scene, frameCamera(scene, {}, size), settings).picture.pixels();
            };
            EXPECT_NE(picture(standardLineTypes), picture(standardLineTypes - LineType::Marked));
        }
        EXPECT_EQ(lengths[0], lengths[1]);
    }
}

TEST_P(RendererLines, areDrawnWithoutATriangleOverEveryShadeAndByEveryDetector) {
    Mesh mesh;
    mesh.lines = {{-1, 0, 0}, {1, 0.5F, 0}};
    const Scene scene = scenes::sceneOf(mesh);
    const auto picture = [&](const Settings& settings) {
        const Maps maps = renderer().render(scene, frameCamera(scene, {}, size), settings);
        std::vector<std::uint8_t> values;  // of the first channel: a shaded picture has three
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) values.push_back(maps.picture(x, y, 0));
        return values;
    };
    const Settings plain = settingsOf(LinesFrom::Object);
    const auto expected = picture(plain);
    for (const Shade shade : {Shade::Flat, Shade::Gooch, Shade::Light, Shade::BaseColor}) {
        Settings settings = plain;
        settings.shade.shade = shade;
        EXPECT_EQ(picture(settings), expected);
    }
    for (const Detector detector : {Detector::Classic, Detector::SaitoTakahashi, Detector::RaskarCohen}) {
        Settings settings = settingsOf(LinesFrom::Image);
        settings.detector.detector = detector;
        EXPECT_NO_THROW(picture(settings));
    }
}

// World length of the lines of a type.
double lengthOf(const Lines& lines, LineType type) {
    double sum = 0.0;
    for (const Line& line : lines.lines)
        for (std::size_t i = 0; line.type == type && i + 1 < line.points.size(); ++i)
            sum += glm::distance(line.points[i].position, line.points[i + 1].position);
    return sum;
}

TEST_P(RendererLines, haveMarkedEdgesInBothSourcesAndEachOnce) {
    // A flat square whose diagonal is marked, and a roof whose ridge is: from image space the ridge is a crease.
    Mesh flat = scenes::quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
    flat.edges.resize(flat.indices.size());
    flat.edges[2] = EdgeKind::Marked;
    Mesh roof;
    roof.positions = {{2, -1, 0}, {4, -1, 0}, {4, 0, 1}, {2, 0, 1}, {4, 1, 0}, {2, 1, 0}};
    roof.indices = {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5};
    roof.edges.resize(roof.indices.size());
    roof.edges[4] = EdgeKind::Marked;
    const Scene scene = scenes::sceneOf({{flat, glm::dmat4{1.0}}, {roof, glm::dmat4{1.0}}});
    const double diagonal = std::sqrt(8.0);
    constexpr double ridge = 2.0;
    constexpr double pixel = 0.1;  // lines between pixels begin and end at whole pixels
    Settings settings = settingsOf(LinesFrom::Image);
    settings.camera.direction = glm::dvec3{0.0, 0.0, -1.0};
    settings.camera.orthographicHeight = 0.0;
    const Camera camera = frameCamera(scene, settings.camera, size);
    const auto found = [&](LinesFrom from, LineTypes types) {
        settings.lines.from = from;
        settings.picture.lines = types;
        return renderer().lines(scene, camera, settings);
    };
    EXPECT_NEAR(lengthOf(found(LinesFrom::Object, standardLineTypes), LineType::Marked), diagonal + ridge, 1e-4);
    const Lines all = found(LinesFrom::Image, standardLineTypes);
    EXPECT_NEAR(lengthOf(all, LineType::Marked), diagonal, 1e-4);
    EXPECT_NEAR(lengthOf(all, LineType::Crease), ridge, pixel);
    EXPECT_NEAR(lengthOf(found(LinesFrom::Image, LineType::Marked), LineType::Marked), diagonal + ridge, 1e-4);
}

TEST_P(RendererLines, warnOfPicturesWithoutTheLinesOfTheFile) {
    Mesh mesh = scenes::cube();
    const Scene without = scenes::sceneOf(mesh);
    mesh.lines = {{-1, 0, 0}, {1, 0.5F, 0}};
    const Scene with = scenes::sceneOf(mesh);
    Settings settings;
    settings.detector.detector = Detector::Classic;
    EXPECT_EQ(renderWarnings(with, settings),
              std::vector<std::string>{"pictures of --detector classic have none of its lines besides triangles: use "
                                       "--detector planes, or --lines-from object"});
    EXPECT_TRUE(renderWarnings(without, settings).empty());
    settings.style.style = Style::Sumi;  // draws no lines
    EXPECT_TRUE(renderWarnings(with, settings).empty());
    settings.style.style = Style::Ink;
    settings.lines.from = LinesFrom::Object;
    EXPECT_TRUE(renderWarnings(with, settings).empty());
    settings.lines.from = LinesFrom::Auto;
    settings.picture.lines = standardLineTypes - LineType::Marked;
    EXPECT_TRUE(renderWarnings(with, settings).empty());
    EXPECT_TRUE(renderWarnings(with, Settings{}).empty());
}

TEST_P(RendererLines, haveLinesOfFormInBothSourcesAndInMaps) {
    const Scene scene =
        scenes::sceneOf(curved::sheet(60, [](double x, double) { return 0.3 * std::exp(-x * x / 0.1); }));
    Settings settings = settingsOf(LinesFrom::Object);
    settings.lines.hidden = HiddenLines::None;
    settings.lines.form.ridgeThreshold = 0.05;  // the fold's curvature of 6 is 0.1 feature sizes per radius
    settings.camera.direction = glm::dvec3{0.0, 0.3, -1.0};
    settings.maps = {Map::Types, Map::Edges};
    const Camera camera = frameCamera(scene, settings.camera, size);
    std::vector<double> lengths;
    for (const LinesFrom from : {LinesFrom::Object, LinesFrom::Image}) {
        settings.lines.from = from;
        settings.picture.lines = standardLineTypes;
        const Maps without = renderer().render(scene, camera, settings);
        settings.picture.lines = standardLineTypes | LineType::Ridge;
        const Lines lines = renderer().lines(scene, camera, settings);
        lengths.push_back(lengthOf(lines, LineType::Ridge));
        const Maps with = renderer().render(scene, camera, settings);
        EXPECT_NE(with.picture.pixels(), without.picture.pixels());
        int ridges = 0;
        for (std::size_t i = 0; i < with.types.pixels().size(); ++i) {
            const auto ridge = static_cast<std::uint16_t>(LineType::Ridge);
            const bool isRidge = (with.types.pixels()[i] & ridge) != 0;
            ridges += isRidge ? 1 : 0;
            EXPECT_EQ(with.types.pixels()[i] & ~ridge, without.types.pixels()[i]) << "the others stay";
            EXPECT_EQ(with.edges.pixels()[i], isRidge ? 255 : without.edges.pixels()[i]);
        }
        EXPECT_GT(ridges, 10);
    }
    EXPECT_NEAR(lengths[0], 2.0, 0.2) << "all along the sheet";
    EXPECT_EQ(lengths[0], lengths[1]);
}

TEST_P(RendererLines, warnOfPicturesWithoutLinesOfForm) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    Settings settings;
    settings.detector.detector = Detector::Classic;
    EXPECT_TRUE(renderWarnings(scene, settings).empty());
    settings.picture.lines = allLineTypes;
    EXPECT_EQ(renderWarnings(scene, settings),
              std::vector<std::string>{"pictures of --detector classic have no lines of form: use --detector planes, "
                                       "or --lines-from object"});
    settings.lines.from = LinesFrom::Object;
    EXPECT_TRUE(renderWarnings(scene, settings).empty());
}

TEST_P(RendererLines, sayWhatFoundThem) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const Settings& settings : everyWay()) {
        const Lines found = linesOf(renderer(), scene, settings);
        EXPECT_EQ(found.size, size);
        EXPECT_EQ(found.camera.view, frameCamera(scene, {}, size).view);
        EXPECT_EQ(found.backend.backend, gl_test::backendName(GetParam()));
        EXPECT_FALSE(found.backend.version.empty());
        EXPECT_FALSE(found.times.empty());
        std::set<LineType> seen;
        bool hidden = false;
        for (const Line& line : found.lines) {
            if (line.visible) seen.insert(line.type);
            hidden = hidden || !line.visible;
            EXPECT_GE(line.points.size(), 2U);
            EXPECT_EQ(line.object, 1U);
        }
        EXPECT_EQ(seen, (std::set{LineType::Outline, LineType::Crease}));
        EXPECT_EQ(hidden, settings.lines.from != LinesFrom::Image) << "the planes detector sees no hidden lines";
    }
}

TEST_P(RendererLines, areCompleteAndHaveTheSameIdsEachTime) {
    const Scene scene = loadScene(INKEDGE_SOURCE_DIR "/assets/teapot.glb");
    for (const Settings& settings : everyWay()) {
        const Lines found = linesOf(renderer(), scene, settings);
        const bool image = settings.lines.from == LinesFrom::Image;
        EXPECT_EQ(found.bounds.centre, scene.bounds().centre);
        EXPECT_EQ(found.bounds.radius, scene.bounds().radius);
        EXPECT_EQ(found.source.name, "teapot.glb");
        EXPECT_EQ(found.source.format, "glTF 2.0");
        EXPECT_EQ(found.source.unit, LengthUnit::Metre);
        EXPECT_EQ(found.source.triangles, scene.triangleCount());
        EXPECT_EQ(found.source.space, image ? LinesFrom::Image : LinesFrom::Object);
        EXPECT_EQ(found.names, namesOf(scene)) << "lines lie on all four nodes";

        std::set<std::uint32_t> ids;
        for (const Line& line : found.lines) ids.insert(line.id);
        EXPECT_EQ(ids.size(), found.lines.size());
        EXPECT_FALSE(ids.contains(0));
        CameraSettings turned;
        turned.azimuthAngle = 77.0;
        (void)renderer().lines(scene, frameCamera(scene, turned, size), settings);
        const Lines again = linesOf(renderer(), scene, settings);
        expectSame(again, found);
        for (std::size_t i = 0; i < found.lines.size(); ++i) EXPECT_EQ(again.lines[i].id, found.lines[i].id);
        EXPECT_EQ(linesJson(again, settings), linesJson(found, settings));
        EXPECT_EQ(linesJson(linesFromJson(linesJson(found, settings)), settings), linesJson(found, settings));
    }
}

TEST(RendererContext, isMadeAtOnceOrWhenACallNeedsIt) {
    const BackendSettings none{Backend::Egl, 4096};  // no machine has this device
    const auto message = HasSubstr("expected an EGL device that");
    expectError(Error::Kind::Usage, message, [&] { const Renderer renderer{none}; });
    for (const ContextTime when : {ContextTime::WhenNeeded, ContextTime::Meanwhile}) {
        Renderer renderer{none, when};
        EXPECT_EQ(renderer.backend().backend, "");
        const Scene scene = scenes::sceneOf(scenes::cube());
        const Lines found = linesOf(renderer, scene, settingsOf(LinesFrom::Object));
        EXPECT_EQ(found.lines.empty(), false);
        EXPECT_EQ(found.backend.backend, "");
        const Camera camera = frameCamera(scene, {}, size);
        const Maps maps = renderer.render(scene, camera, settingsOf(LinesFrom::Object));
        EXPECT_EQ(maps.picture.size(), size);
        EXPECT_EQ(maps.backend.backend, "");
        expectError(Error::Kind::Usage, message, [&] { (void)linesOf(renderer, scene, settingsOf(LinesFrom::Image)); });
        expectError(Error::Kind::Usage, message,
                    [&] { (void)renderer.render(scene, camera, settingsOf(LinesFrom::Image)); });
    }
}

TEST_P(RendererLines, areTheSameWithAContextMadeMeanwhile) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Settings settings = settingsOf(LinesFrom::Image);
    Renderer meanwhile{BackendSettings{GetParam(), {}}, ContextTime::Meanwhile};
    expectSame(linesOf(meanwhile, scene, settings), linesOf(renderer(), scene, settings));
    EXPECT_EQ(meanwhile.backend().backend, gl_test::backendName(GetParam()));
    const Renderer unused{BackendSettings{GetParam(), {}}, ContextTime::Meanwhile};
    EXPECT_EQ(unused.backend().backend, "");
}

TEST_P(RendererLines, pictureIsTheSameWithoutAContext) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const Camera camera = frameCamera(scene, {}, size);
    const Settings settings = settingsOf(LinesFrom::Object);
    Renderer lazy{BackendSettings{GetParam(), {}}, ContextTime::WhenNeeded};
    EXPECT_EQ(lazy.render(scene, camera, settings).picture.pixels(),
              renderer().render(scene, camera, settings).picture.pixels());
    EXPECT_EQ(lazy.backend().backend, "");
    const Maps drawn = lazy.render(scene, camera, settingsOf(LinesFrom::Image));
    EXPECT_EQ(drawn.backend.backend, gl_test::backendName(GetParam()));
    EXPECT_EQ(drawn.times.front().stage, "context");
}

TEST_P(RendererLines, rememberNothingOfTheSceneBefore) {
    const Scene first = scenes::sceneOf(scenes::sphere());
    const Scene second = scenes::sceneOf(scenes::cube());
    for (const Settings& settings : everyWay()) {
        Renderer fresh{BackendSettings{GetParam(), {}}};
        const Lines alone = linesOf(fresh, second, settings);
        Renderer used{BackendSettings{GetParam(), {}}};
        EXPECT_NE(linesOf(used, first, settings).lines.size(), alone.lines.size());
        expectSame(linesOf(used, second, settings), alone);
        (void)used.render(first, frameCamera(first, {}, size), settings);
        expectSame(linesOf(used, second, settings), alone);
    }
}

TEST_P(RendererLines, ofASceneThatStandsWhereADeadOneStoodAreItsOwn) {
    for (const Settings& settings : everyWay()) {
        Camera camera;
        std::vector<double> reach;
        for (const double side : {0.5, 1.5}) {
            const Scene scene = scenes::sceneOf(scenes::cube(side));
            if (reach.empty()) camera = frameCamera(scenes::sceneOf(scenes::cube(2.0)), {}, size);
            double largestX = 0.0;
            for (const Line& line : renderer().lines(scene, camera, settings).lines) {
                for (const LinePoint& p : line.points) largestX = std::max(largestX, p.position.x);
            }
            reach.push_back(largestX);
        }
        // In image space a corner is found to a pixel, of which half a side of the smaller cube has seven.
        EXPECT_NEAR(reach.at(1) / reach.at(0), 3.0, 3.0 / 7.0);
    }
}

TEST_P(RendererLines, leaveTheCallersContextCurrent) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const gl::Current outer{context()};
    float value = 0.0F;
    for (const Settings& settings : everyWay()) {
        value += 0.125F;
        context().api().ClearColor(value, 0, 0, 0);
        (void)linesOf(renderer(), scene, settings);
        GLfloat color[4]{-1.0F};
        context().api().GetFloatv(GL_COLOR_CLEAR_VALUE, color);
        EXPECT_EQ(color[0], value);
    }
}

TEST_P(RendererLines, leaveTheCallersContextCurrentWhenTheyFail) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    const gl::Current outer{context()};
    context().api().ClearColor(0.375F, 0, 0, 0);
    Settings classic = settingsOf(LinesFrom::Image);
    classic.detector.detector = Detector::Classic;
    expectError(Error::Kind::Usage, HasSubstr("lines from image: expected the planes detector, found"),
                [&] { (void)linesOf(renderer(), scene, classic); });
    Settings gauss = settingsOf(LinesFrom::Object);
    gauss.lines.contourFinder = ContourFinder::Gauss;
    expectError(Error::Kind::Usage, HasSubstr("expected an orthographic camera for gauss"),
                [&] { (void)linesOf(renderer(), scene, gauss); });
    GLfloat color[4]{-1.0F};
    context().api().GetFloatv(GL_COLOR_CLEAR_VALUE, color);
    EXPECT_EQ(color[0], 0.375F);
}

TEST_P(RendererLines, areFoundOnSeveralThreadsWithARendererEach) {
    const Scene scene = scenes::sceneOf(scenes::sphere());
    for (const Settings& settings : everyWay()) {
        const Lines alone = linesOf(renderer(), scene, settings);
        std::vector<Lines> results(2);
        std::vector<std::thread> threads;
        for (Lines& result : results) {
            threads.emplace_back([&] {
                Renderer own{BackendSettings{GetParam(), {}}};
                result = linesOf(own, scene, settings);
            });
        }
        for (std::thread& thread : threads) thread.join();
        for (const Lines& result : results) expectSame(result, alone);
    }
}

// Steep narrow facets that lie between two pixels: what the pixels see does not go on, but the surface does.
TEST_P(RendererLines, fromImageHaveNoneWhereASteepSurfaceGoesOn) {
    LoadSettings smooth;
    smooth.creaseAngle = 90.0;
    const Scene scene = loadScene(INKEDGE_SOURCE_DIR "/assets/statue.glb", smooth);
    const Size whole{320, 480};
    for (const double azimuth : {160.0, 35.0, -30.0, 90.0}) {
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = azimuth;
        cameraSettings.elevationAngle = 8.0;
        const Camera camera = frameCamera(scene, cameraSettings, whole);
        Settings settings = settingsOf(LinesFrom::Object);
        settings.picture.size = whole;
        Image<std::uint8_t> near{whole, 1};  // a line of the mesh, seen or hidden, within two pixels
        for (const Line& line : renderer().lines(scene, camera, settings).lines) {
            for (std::size_t i = 1; i < line.points.size(); ++i) {
                const glm::dvec2 from = line.points[i - 1].pixel;
                const glm::dvec2 way = line.points[i].pixel - from;
                const int steps = 1 + static_cast<int>(2.0 * glm::length(way));
                for (int k = 0; k <= steps; ++k) {
                    const glm::ivec2 at{glm::floor(from + way * (static_cast<double>(k) / steps))};
                    for (int y = std::max(at.y - 2, 0); y <= std::min(at.y + 2, whole.height - 1); ++y)
                        for (int x = std::max(at.x - 2, 0); x <= std::min(at.x + 2, whole.width - 1); ++x)
                            near.at(x, y) = 1;
                }
            }
        }
        settings.lines.from = LinesFrom::Image;
        settings.maps = {Map::Edges};
        const Image<std::uint8_t> edges = renderer().render(scene, camera, settings).edges;
        int stray = 0;
        for (std::size_t i = 0; i < edges.pixels().size(); ++i)
            stray += edges.pixels()[i] != 0 && near.pixels()[i] == 0 ? 1 : 0;
        EXPECT_GT(std::ranges::count(edges.pixels(), 255), 500);
        EXPECT_EQ(stray, 0) << "from " << azimuth << " degrees";
    }
}

}  // namespace
}  // namespace inkedge::render
