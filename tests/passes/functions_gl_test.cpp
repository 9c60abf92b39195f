// Surface functions: Hertzmann 1999, section 2.1.3.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include <inkedge/setting_table.h>

#include "reference/reference.h"

#include "gl/gl_test.h"
#include "gl/read_back.h"
#include "passes/draw_function.h"
#include "passes/function_edges.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

using gl_test::toDouble;
using testing::HasSubstr;

INKEDGE_ON_EACH_BACKEND(Functions);

constexpr Size size{96, 72};
constexpr double noValue = 1e29;

LoadSettings everything() {
    LoadSettings settings;
    settings.textureCoordinates = true;
    settings.paint = true;
    settings.curvature = true;
    return settings;
}

// Around the sphere and from its pole down; so many times.
Mesh mappedSphere(float repeat = 1.0F) {
    Mesh mesh = scenes::sphere(1.0, 48);
    for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
        const glm::vec2 uv{static_cast<float>(i % 49U) / 48.0F, static_cast<float>(i / 49U) / 24.0F};
        mesh.textureCoordinates.push_back(repeat * uv);
        mesh.paint.push_back({{uv, 0.5F, 1.0F}, {}});
    }
    return mesh;
}

Scene mixedScene() {
    return scenes::sceneOf({{mappedSphere(), scenes::translation({-0.8, 0.3, 0.5})},
                            {scenes::box({2, 1, 1.5}), scenes::rotation(30, {1, 2, 0})}},
                           everything());
}

Camera cameraFor(const Scene& scene, bool orthographic) {
    CameraSettings cameraSettings;
    cameraSettings.azimuthAngle = 25.0;
    if (orthographic) cameraSettings.orthographicHeight = 0.0;
    return frameCamera(scene, cameraSettings, size);
}

class Bench {
public:
    Bench(gl::Gpu& gpu, const Scene& scene) : gpu_{gpu}, scene_{scene}, upload_{gpu.api, scene}, inputs_{gpu.api} {}

    Image<float> values(const Camera& camera, const FunctionSettings& function) {
        return gl::readFloats(gpu_.api, draw(camera, function), 4);
    }
    Image<float> magnitude(const Camera& camera, const FunctionSettings& function) {
        return gl::readFloats(gpu_.api, measureFunction(gpu_, draw(camera, function), function), 1);
    }

private:
    gl::Texture draw(const Camera& camera, const FunctionSettings& function) {
        return drawFunction(frameOf(gpu_, upload_, scene_, camera, size), inputs_, function);
    }

    gl::Gpu& gpu_;
    const Scene& scene_;
    gl::UploadedScene upload_;
    gl::FunctionInputs inputs_;
};

struct Differences {
    int pixels = 0;   // of the surface
    int far = 0;      // off by more than the tolerance in any channel
    int covered = 0;  // on the surface in one only
};

Differences differencesOf(const Image<float>& found, const Image<double>& expected, double tolerance) {
    Differences differences;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            const bool there = static_cast<double>(found.at(x, y, 3)) < noValue;
            if (there != (expected.at(x, y, 3) < noValue)) {
                ++differences.covered;
                continue;
            }
            if (!there) continue;
            ++differences.pixels;
            double worst = 0.0;
            for (int c = 0; c < 4; ++c)
                worst = std::max(worst, std::abs(static_cast<double>(found.at(x, y, c)) - expected.at(x, y, c)));
            if (worst > tolerance) ++differences.far;
        }
    }
    return differences;
}

// Functions that count steps differ by whole steps where a value is within rounding of one.
bool countsSteps(const FunctionSettings& function) {
    return function.name == "uv" || function.name == "height" || function.name == "curvature" ||
           (function.name == "volume" && function.options[0] > 0.0);
}

TEST_P(Functions, equalTheirDefinitions) {
    const gl::Current current{context()};
    const Scene scene = mixedScene();
    Bench bench{gpu(), scene};
    for (const bool orthographic : {false, true}) {
        const Camera camera = cameraFor(scene, orthographic);
        for (const char* const text :
             {"depth", "depth:map=window", "normal", "normal:space=world", "texture", "texture:repeat=2.5",
              "base-color", "environment", "environment:space=world", "volume", "volume:kind=gradient",
              "volume:kind=stripes,axis=x", "curvature", "curvature:scale=3,steps=7", "uv", "uv:step=0.05,direction=v",
              "height", "height:axis=x,step=0.3"}) {
            SCOPED_TRACE(testing::Message() << text << (orthographic ? ", orthographic" : ", perspective"));
            const FunctionSettings function = surfaceFunction(text);
            const Image<double> expected = reference::drawFunction(scene, camera, function, size);
            // Floats of values up to 10, interpolated over triangles: some 1e-6 of them; normals are no better where
            // many thin triangles meet. Curvatures are up to 100 where faces are thin.
            const Differences found = differencesOf(bench.values(camera, function), expected, 2e-4);
            EXPECT_GT(found.pixels, 1000);
            EXPECT_LE(found.covered, 12) << "pixels whose centre lies within the grid of vertices of an edge";
            // On edges between triangles, which have values of their own on both sides, either may be drawn.
            EXPECT_LE(found.far, countsSteps(function) ? 40 : 25);
        }
    }
}

TEST_P(Functions, haveTheMagnitudesOfTheirDefinition) {
    const gl::Current current{context()};
    const Scene scene = mixedScene();
    Bench bench{gpu(), scene};
    const Camera camera = cameraFor(scene, false);
    for (const char* const text : {"depth", "normal", "texture:repeat=3", "uv:step=0.125", "volume", "base-color"}) {
        for (const char* const kernel : {"sobel", "farid"}) {
            SCOPED_TRACE(testing::Message() << text << ", " << kernel);
            FunctionSettings function = surfaceFunction(text);
            function.kernel = kernel == std::string_view{"sobel"} ? Kernel::Sobel : Kernel::Farid;
            const Image<double> expected =
                reference::functionMagnitude(toDouble(bench.values(camera, function)), function);
            const Image<float> found = bench.magnitude(camera, function);
            const double largest = *std::ranges::max_element(expected.pixels());
            EXPECT_GT(largest, 0.0);
            int off = 0;
            for (std::size_t i = 0; i < found.pixels().size(); ++i) {
                // A sum of 25 products in float: 25 * 6e-8 of the largest, with room.
                if (std::abs(static_cast<double>(found.pixels()[i]) - expected.pixels()[i]) >
                    1e-5 * std::max(largest, 1.0))
                    ++off;
            }
            EXPECT_LE(off, 2) << "pixels where a difference is within rounding of half the period";
        }
    }
}

Image<std::uint8_t> edgesOf(Renderer& renderer, const Scene& scene, const Camera& camera, const char* functions,
                            Detector detector = Detector::None, int samples = 1) {
    Settings settings;
    settings.picture.size = size;
    settings.picture.supersampling = samples;
    settings.maps = {Map::Edges};
    settings.detector.detector = detector;
    if (*functions != '\0') set(settings, "function", functions, "");
    return renderer.render(scene, camera, settings).edges;
}

long marked(const Image<std::uint8_t>& mask) { return std::ranges::count(mask.pixels(), 255); }

TEST_P(Functions, depthAndNormalAreTheClassicDetector) {
    const Scene scene = mixedScene();
    const Camera camera = cameraFor(scene, false);
    const Image<std::uint8_t> classic = edgesOf(renderer(), scene, camera, "", Detector::Classic);
    const Image<std::uint8_t> functions = edgesOf(renderer(), scene, camera, "depth;normal");
    long differing = 0;
    for (std::size_t i = 0; i < classic.pixels().size(); ++i)
        differing += classic.pixels()[i] != functions.pixels()[i] ? 1 : 0;
    EXPECT_GT(marked(classic), 300);
    EXPECT_LE(differing, 2) << "pixels whose magnitude is within rounding of T";
}

TEST_P(Functions, ofARepeatedTextureHaveNoSeams) {
    // A sphere seen from where its texture begins anew, with a margin around its rim and its poles left out.
    for (const float repeat : {1.0F, 4.0F}) {
        const Scene scene = scenes::sceneOf({{mappedSphere(repeat), glm::dmat4{1.0}}}, everything());
        CameraSettings cameraSettings;
        cameraSettings.azimuthAngle = 0.0;
        cameraSettings.elevationAngle = 0.0;
        const Camera camera = frameCamera(scene, cameraSettings, size);
        const gl::Current current{context()};
        Bench bench{gpu(), scene};
        FunctionSettings function = surfaceFunction("texture");
        const auto largestInside = [&](const Image<double>& magnitude) {
            double largest = 0.0;
            for (int y = 24; y < 48; ++y)
                for (int x = 36; x < 60; ++x) largest = std::max(largest, magnitude.at(x, y));
            return largest;
        };
        const Image<float> values = bench.values(camera, function);
        // Twice the steepest slope there: 24 pixels are a seventh of the way around or less.
        const double slope = 8.0 * static_cast<double>(repeat) / 96.0;
        EXPECT_LT(largestInside(toDouble(bench.magnitude(camera, function))), 2.0 * slope);
        function.file = "not looked at";  // as if its differences were not to be wrapped
        EXPECT_GT(largestInside(reference::functionMagnitude(toDouble(values), function)), 3.0)
            << "the seam is in view";
    }
}

TEST_P(Functions, isoparametricLinesAreTheSameAtASeam) {
    const Scene scene = scenes::sceneOf({{mappedSphere(), glm::dmat4{1.0}}}, everything());
    CameraSettings cameraSettings;
    cameraSettings.elevationAngle = 0.0;
    const auto lines = [&](double azimuth) {
        cameraSettings.azimuthAngle = azimuth;
        return marked(
            edgesOf(renderer(), scene, frameCamera(scene, cameraSettings, size), "uv:step=0.125,direction=u"));
    };
    // An eighth of a turn on, lines stand where others stood before, the seam among them.
    EXPECT_NEAR(static_cast<double>(lines(0.0)), static_cast<double>(lines(45.0)),
                0.05 * static_cast<double>(lines(45.0)));
}

TEST_P(Functions, levelsOfAFlatFaceAreNoNoise) {
    // The top lies in a level, and so does the middle of the side.
    const Scene scene = scenes::sceneOf(scenes::box({2, 2, 2}));
    CameraSettings cameraSettings;
    cameraSettings.elevationAngle = 60.0;
    cameraSettings.azimuthAngle = 0.0;
    const Camera camera = frameCamera(scene, cameraSettings, size);
    const Image<std::uint8_t> edges = edgesOf(renderer(), scene, camera, "height:levels=2");
    EXPECT_GT(marked(edges), 0);
    for (int y = 20; y < 28; ++y)
        for (int x = 40; x < 56; ++x) EXPECT_EQ(edges.at(x, y), 0) << x << ", " << y;
}

TEST_P(Functions, areDrawnOverTheDetectorsLines) {
    const Scene scene = mixedScene();
    const Camera camera = cameraFor(scene, false);
    const Image<std::uint8_t> planes = edgesOf(renderer(), scene, camera, "", Detector::Planes);
    const Image<std::uint8_t> heights = edgesOf(renderer(), scene, camera, "height");
    const Image<std::uint8_t> both = edgesOf(renderer(), scene, camera, "height", Detector::Planes);
    for (std::size_t i = 0; i < both.pixels().size(); ++i)
        EXPECT_EQ(both.pixels()[i], std::max(planes.pixels()[i], heights.pixels()[i]));
    EXPECT_GT(marked(both), marked(planes));
}

TEST_P(Functions, haveSmoothFinerLinesWithMoreSamples) {
    const Scene scene = mixedScene();
    Settings settings;
    settings.picture.size = size;
    settings.detector.detector = Detector::None;
    set(settings, "function", "height", "");
    const Camera camera = cameraFor(scene, false);
    const auto darkness = [&](int samples) {
        settings.picture.supersampling = samples;
        double sum = 0.0;
        for (const std::uint8_t p : renderer().render(scene, camera, settings).picture.pixels()) sum += 255.0 - p;
        return sum;
    };
    // Lines are two samples wide.
    EXPECT_NEAR(darkness(2) / darkness(1), 0.5, 0.1);
}

TEST_P(Functions, inTilesAreTheSame) {
    const Scene scene = mixedScene();
    constexpr Size large{600, 400};
    Settings settings;
    settings.picture.size = large;
    settings.detector.detector = Detector::SaitoTakahashi;
    settings.maps = {Map::Edges};
    set(settings, "function", "uv;volume:kernel=farid", "");
    const Camera camera = frameCamera(scene, {}, large);
    const Maps whole = renderer().render(scene, camera, settings);
    settings.picture.tileSize = 256;
    const Maps tiled = renderer().render(scene, camera, settings);
    long differing = 0;
    for (std::size_t i = 0; i < whole.edges.pixels().size(); ++i) {
        differing += whole.edges.pixels()[i] != tiled.edges.pixels()[i] ? 1 : 0;
        differing += std::abs(whole.picture.pixels()[i] - tiled.picture.pixels()[i]) > 8 ? 1 : 0;
    }
    EXPECT_LE(differing, 20) << "places within rounding of a step, where interpolation starts elsewhere";
    EXPECT_GT(marked(whole.edges), 1000);
}

TEST_P(Functions, areRefusedWithoutTheCurvatureThatTheyRead) {
    const Scene without = scenes::sceneOf(scenes::cube());
    const Camera camera = cameraFor(without, false);
    for (const char* const function : {"curvature", "height;curvature:steps=7"}) {
        SCOPED_TRACE(function);
        try {
            (void)edgesOf(renderer(), without, camera, function);
            ADD_FAILURE() << "drawn";
        } catch (const Error& error) {
            EXPECT_EQ(error.kind(), Error::Kind::Usage);
            EXPECT_STREQ(error.what(),
                         "scene: expected one made with its curvature, which functions read, found one made without; "
                         "give the settings that draw it to what makes it, too: in C++ loadSettings(settings)");
        }
    }
    EXPECT_NO_THROW((void)edgesOf(renderer(), without, camera, "height"));
    EXPECT_NO_THROW((void)edgesOf(renderer(), scenes::sceneOf({{scenes::cube(), glm::dmat4{1.0}}}, everything()),
                                  camera, "curvature"));
}

TEST_P(Functions, areRefusedWithoutTheNormalsThatTheyRead) {
    LoadSettings load = everything();
    load.completeNormals = false;
    const Scene without = scenes::sceneOf({{scenes::cube(), glm::dmat4{1.0}}}, load);
    try {
        (void)edgesOf(renderer(), without, cameraFor(without, false), "height");
        FAIL() << "drawn";
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Usage);
        EXPECT_STREQ(error.what(),
                     "scene: expected one with a normal at every vertex, which lines of the mesh, shades, styles and "
                     "maps of normals read, found one loaded without LoadSettings::completeNormals");
    }
}

TEST_P(Functions, areRefusedWithoutTextureCoordinates) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    try {
        (void)edgesOf(renderer(), scene, cameraFor(scene, false), "uv");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        EXPECT_STREQ(error.what(), "function uv: expected a model with texture coordinates, found none");
    }
}

// A user's shader in a folder of its own.
class CustomShader {
public:
    explicit CustomShader(const std::string& text) {
        std::string pattern = (std::filesystem::temp_directory_path() / "inkedge-custom-XXXXXX").string();
        folder_ = ::mkdtemp(pattern.data());
        std::ofstream{file()} << text;
    }
    ~CustomShader() { std::filesystem::remove_all(folder_); }
    CustomShader(const CustomShader&) = delete;
    CustomShader& operator=(const CustomShader&) = delete;
    [[nodiscard]] std::string file() const { return (folder_ / "mine.glsl").string(); }

private:
    std::filesystem::path folder_;
};

TEST_P(Functions, ofAUserAreDrawnLikeOurs) {
    const CustomShader mine{
        "// Height in half units.\nvec4 surface(Surface s) {\n"
        "    return vec4(stepsIn((s.world.y - lowest.y) / option[0]), 0.0, 0.0, 0.0);\n}\n"};
    const Scene scene = mixedScene();
    const Camera camera = cameraFor(scene, false);
    const Image<std::uint8_t> ours = edgesOf(renderer(), scene, camera, "height:step=0.5");
    const Image<std::uint8_t> theirs =
        edgesOf(renderer(), scene, camera, ("custom:" + mine.file() + ",a=0.5,threshold=2").c_str());
    EXPECT_EQ(ours, theirs);
    EXPECT_GT(marked(ours), 50);
}

std::string refusalOf(Renderer& renderer, const std::string& text) {
    const CustomShader mine{text};
    const Scene scene = mixedScene();
    try {
        (void)edgesOf(renderer, scene, cameraFor(scene, false), ("custom:" + mine.file()).c_str());
    } catch (const Error& error) {
        EXPECT_EQ(error.kind(), Error::Kind::Input);
        const std::string what = error.what();
        EXPECT_EQ(what.rfind(mine.file(), 0), 0U) << what;
        return what.substr(std::min(mine.file().size(), what.size()));
    }
    return {};
}

TEST_P(Functions, ofAUserAreRefusedByFileAndLine) {
    EXPECT_THAT(refusalOf(renderer(), "vec4 surface(Surface s) {\n\n    return vec4(s.heigth);\n}\n"),
                testing::AllOf(HasSubstr(":3: expected GLSL that the driver accepts, found: "), HasSubstr("heigth")));
    EXPECT_THAT(refusalOf(renderer(), "vec4 surface(Surface s) { return vec4(1.0); }\nfloat f( {\n"),
                HasSubstr(":2: "));
    EXPECT_THAT(refusalOf(renderer(), "float nothing() { return 1.0; }\n"), HasSubstr("vec4 surface(Surface s)"));
    const std::string twice = refusalOf(renderer(), "vec4 surface(Surface s) { return s; }");
    EXPECT_EQ(std::ranges::count(twice, '\n'), 0) << twice;
}

TEST_P(Functions, ofAUserMayNotBeNumbers) {
    const CustomShader mine{"vec4 surface(Surface s) { return vec4(sqrt(-1.0 - s.depth * s.depth)); }"};
    const Scene scene = mixedScene();
    const Camera camera = cameraFor(scene, false);
    EXPECT_EQ(marked(edgesOf(renderer(), scene, camera, ("custom:" + mine.file()).c_str())), 0);
}

TEST_P(Functions, allHaveAShader) {
    const gl::Current current{context()};
    for (const FunctionDescription& row : functionTable()) EXPECT_NE(gpu().programs.function(row.name), 0U) << row.name;
    EXPECT_EQ(gl::functionTexts().size(), functionTable().size() + 1) << "shaders/functions holds one for each row";
}

TEST_P(Functions, profilesAndInternalEdgesEqualTheirDefinition) {
    const Scene scene = mixedScene();
    for (const bool orthographic : {false, true}) {
        const Camera camera = cameraFor(scene, orthographic);
        Settings settings;
        settings.picture.size = size;
        settings.maps = {Map::Depth, Map::Normal};
        settings.detector.detector = Detector::SaitoTakahashi;
        const Maps maps = renderer().render(scene, camera, settings);
        const Image<double> ink =
            reference::detectProfiles(toDouble(maps.depth), toDouble(maps.normal), camera, settings.detector);
        int far = 0;
        double sum = 0.0;
        for (std::size_t i = 0; i < ink.pixels().size(); ++i) {
            sum += ink.pixels()[i];
            // Black ink on white. Depths in footprints are rounded to 6e-8 of some 100 pixels of focal length, which
            // the limit of 0.6 magnifies: far under half a step of 8 bits.
            if (std::abs(255.0 - maps.picture.pixels()[i] - 255.0 * ink.pixels()[i]) > 1.0) ++far;
        }
        EXPECT_GT(sum, 200.0);
        EXPECT_EQ(far, 0);
    }
}

TEST_P(Functions, profilesKnowNoSlope) {
    // A plane in perspective, however steep, has neither profiles nor edges.
    const Scene scene = scenes::sceneOf(scenes::quad({-3, 0, 3}, {3, 0, 3}, {3, 0, -60}, {-3, 0, -60}));
    CameraSettings cameraSettings;
    cameraSettings.position = {0.0, 1.0, 6.0};
    cameraSettings.focalPoint = {0.0, 0.0, 0.0};
    Settings settings;
    settings.picture.size = size;
    settings.maps = {Map::Normal};
    settings.detector.detector = Detector::SaitoTakahashi;
    const Maps maps = renderer().render(scene, frameCamera(scene, cameraSettings, size), settings);
    int inked = 0;
    int seen = 0;
    for (int y = 4; y < size.height - 4; ++y) {
        for (int x = 4; x < size.width - 4; ++x) {
            bool inside = true;
            for (int i = 0; i < 49; ++i) inside = inside && maps.normal.at(x + i % 7 - 3, y + i / 7 - 3, 1) != 0.0F;
            if (!inside) continue;
            ++seen;
            if (maps.picture.at(x, y) < 250) ++inked;
        }
    }
    EXPECT_GT(seen, 500);
    EXPECT_EQ(inked, 0);
}

}  // namespace
}  // namespace inkedge::passes
