// Views along axes and diagonals, where flat faces are seen exactly edge-on: both sources of lines must agree, and a
// camera turned by next to nothing must see the same.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include <inkedge/load_scene.h>

#ifdef INKEDGE_CAD_FILES
#include "formats/cad/cad_files.h"
#endif
#include "gl/gl_test.h"
#include "render/ink_of_lines.h"
#include "scenes.h"

namespace inkedge::render {
namespace {

INKEDGE_ON_EACH_BACKEND(AxisViews);

using ink_of_lines::alone;
using ink_of_lines::Ink;
using ink_of_lines::inkOf;
using ink_of_lines::square;

double lengthOf(const std::vector<Ink>& ink, LineType type) {
    double sum = 0.0;
    for (const Ink& dot : ink) sum += dot.type == type ? dot.length : 0.0;
    return sum;
}

// Along the axes, and between two and between three of them.
std::vector<CameraSettings> directions() {
    std::vector<CameraSettings> all;
    for (const double height : {-1.0, 0.0}) {  // below 0: perspective
        for (double elevation = -90.0; elevation <= 90.0; elevation += 45.0) {
            for (double azimuth = 0.0; azimuth < (std::abs(elevation) == 90.0 ? 45.0 : 360.0); azimuth += 45.0) {
                CameraSettings& view = all.emplace_back();
                view.azimuthAngle = azimuth;
                view.elevationAngle = elevation;
                if (height == 0.0) view.orthographicHeight = height;
            }
        }
    }
    return all;
}

// The same view of a scene that is turned about its middle, a little about two axes.
Camera turned(Camera camera, const Scene& scene, double degrees) {
    const glm::dvec3 middle = scene.bounds().centre;
    camera.view = camera.view * scenes::translation(middle) * scenes::rotation(degrees, {1, 0, 0}) *
                  scenes::rotation(degrees, {0, 1, 0}) * scenes::translation(-middle);
    return camera;
}

// The most, in pixels, of the lines of any one view that have no counterpart.
struct Alone {
    double image = 0.0;   // from image space, in object space
    double object = 0.0;  // from object space, in image space
    double turned = 0.0;  // of a scene turned by a hundredth of a degree, in the exact view
    double exact = 0.0;   // in both scenes turned, one each way
    std::string where;    // of the worst
};

Alone aloneIn(Renderer& renderer, const Scene& scene) {
    Alone largest;
    double worst = 0.0;
    for (const CameraSettings& view : directions()) {
        const Camera camera = frameCamera(scene, view, square);
        const auto inkFrom = [&](LinesFrom from, double degrees) {
            Settings settings;
            settings.picture.size = square;
            settings.lines.from = from;
            return inkOf(renderer.lines(scene, turned(camera, scene, degrees), settings));
        };
        constexpr double little = 0.01;
        const std::vector<Ink> image = inkFrom(LinesFrom::Image, 0.0);
        const std::vector<Ink> object = inkFrom(LinesFrom::Object, 0.0);
        const std::vector<Ink> left = inkFrom(LinesFrom::Object, little);
        const std::vector<Ink> right = inkFrom(LinesFrom::Object, -little);
        const std::array found{alone(image, {&object}), alone(object, {&image}),
                               std::min(alone(left, {&object}), alone(right, {&object})),
                               alone(object, {&left, &right})};
        largest.image = std::max(largest.image, found[0]);
        largest.object = std::max(largest.object, found[1]);
        largest.turned = std::max(largest.turned, found[2]);
        largest.exact = std::max(largest.exact, found[3]);
        if (std::ranges::max(found) > worst) {
            worst = std::ranges::max(found);
            largest.where = std::string{view.orthographicHeight ? "orthographic" : "perspective"} + ", azimuth " +
                            std::to_string(static_cast<int>(*view.azimuthAngle)) + ", elevation " +
                            std::to_string(static_cast<int>(*view.elevationAngle));
        }
    }
    return largest;
}

std::vector<glm::dvec2> roundedRectangle(double width, double depth, double radius, int steps) {
    std::vector<glm::dvec2> outline;
    for (int corner = 0; corner < 4; ++corner) {
        const glm::dvec2 sign{corner == 0 || corner == 3 ? 1 : -1, corner < 2 ? 1 : -1};
        for (int k = 0; k <= steps; ++k) {
            const double angle = 0.5 * std::numbers::pi * (corner + static_cast<double>(k) / steps);
            outline.push_back(sign * glm::dvec2{0.5 * width - radius, 0.5 * depth - radius} +
                              radius * glm::dvec2{std::cos(angle), std::sin(angle)});
        }
    }
    return outline;
}

// An outline, pulled along the y axis in steps.
Mesh pulled(const std::vector<glm::dvec2>& outline, double height, std::uint32_t steps, bool capped) {
    Mesh mesh;
    mesh.name = "pulled";
    const auto count = static_cast<std::uint32_t>(outline.size());
    for (std::uint32_t k = 0; k <= steps; ++k)
        for (const glm::dvec2 p : outline) mesh.positions.emplace_back(p.x, height * (double(k) / steps - 0.5), p.y);
    for (std::uint32_t k = 0; k < steps; ++k) {
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t a = k * count + i;
            const std::uint32_t b = k * count + (i + 1) % count;
            mesh.indices.insert(mesh.indices.end(), {a, a + count, b + count, a, b + count, b});
        }
    }
    for (std::uint32_t i = 1; capped && i + 1 < count; ++i) {
        const std::uint32_t top = steps * count;
        mesh.indices.insert(mesh.indices.end(), {0, i, i + 1, top, top + i + 1, top + i});
    }
    return mesh;
}

// As programs write positions: five digits, of which many write more.
Mesh rounded(Mesh mesh) {
    for (glm::vec3& p : mesh.positions) {
        for (int axis = 0; axis < 3; ++axis) {
            std::array<char, 32> text{};
            std::snprintf(text.data(), text.size(), "%.5g", static_cast<double>(p[axis]));
            p[axis] = std::stof(text.data());
        }
    }
    return mesh;
}

Mesh turnedInItself(Mesh mesh, double degrees, glm::dvec3 axis) {
    for (glm::vec3& p : mesh.positions) p = glm::vec3{scenes::rotation(degrees, axis) * glm::dvec4{glm::dvec3{p}, 1.0}};
    return mesh;
}

Mesh insideOut(Mesh mesh) {
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) std::swap(mesh.indices[i], mesh.indices[i + 1]);
    return mesh;
}

TEST_P(AxisViews, ofSolidsAreThoseOfImageSpaceAndOfACameraTurnedByNextToNothing) {
    const Mesh bar = pulled(roundedRectangle(4.0, 1.5, 0.5, 6), 1.0, 1, true);
    // Its flat sides are of faces a pixel high and as long as the bar, its rounded corners of small ones.
    const Mesh strips = pulled(roundedRectangle(4.0, 1.5, 0.5, 24), 1.0, 40, true);
    const Mesh cylinder = pulled(roundedRectangle(2.0, 2.0, 1.0, 8), 2.0, 5, true);
    const std::vector<std::pair<const char*, Mesh>> solids{
        {"cube", scenes::cube()},
        {"cube, turned", turnedInItself(scenes::cube(), 45.0, {0, 1, 0})},
        {"bar", bar},
        {"bar, inside out", insideOut(bar)},
        {"bar, turned", turnedInItself(bar, 45.0, {0, 1, 0})},
        {"bar, turned and rounded", rounded(turnedInItself(bar, 45.0, {0, 1, 0}))},
        {"cylinder, turned and rounded", rounded(turnedInItself(cylinder, 45.0, {1, 0, 0}))},
        {"bar of strips, along y", rounded(turnedInItself(strips, 45.0, {0, 1, 0}))},
        {"bar of strips, along z", rounded(turnedInItself(strips, 45.0, {0, 0, 1}))},
        {"sphere", scenes::sphere(1.0, 96)},
    };
    for (const auto& [name, mesh] : solids) {
        const Alone found = aloneIn(renderer(), scenes::sceneOf(mesh));
        SCOPED_TRACE(testing::Message() << name << ": " << found.where);
        EXPECT_LE(found.image, 0.5);
        EXPECT_LE(found.object, 0.5);
        EXPECT_LE(found.turned, 0.5);
        EXPECT_LE(found.exact, 0.5);
    }
}

#ifdef INKEDGE_CAD_FILES
TEST_P(AxisViews, ofCadPartsAreThoseOfImageSpaceToo) {
    using cad_files::Shape;
    const std::vector<std::pair<const char*, std::string>> parts{
        {"cone", cad_files::brep(Shape::Cone)},
        {"cylinder", cad_files::brep(Shape::Cylinder)},
        {"rounded box", cad_files::brep(Shape::Rounded)},
        {"tiny cylinder", cad_files::scaledStep(Shape::Cylinder, 1e-6)},
        {"huge cylinder", cad_files::scaledStep(Shape::Cylinder, 1e6)},
    };
    for (const auto& [name, text] : parts) {
        LoadSettings load;
        load.pictures.picture.size = square;
        const Alone found =
            aloneIn(renderer(), loadScene(std::vector<std::uint8_t>{text.begin(), text.end()}, name, load));
        SCOPED_TRACE(testing::Message() << name << ": " << found.where);
        EXPECT_LE(found.image, 0.5);
        EXPECT_LE(found.object, 0.5);
        EXPECT_LE(found.turned, 0.5);
        EXPECT_LE(found.exact, 0.5);
    }
}
#endif

// Image space does not see a surface without thickness from its edge: it covers no pixel.
TEST_P(AxisViews, ofOpenSurfacesLackNoLine) {
    const Mesh tube = pulled(roundedRectangle(4.0, 1.5, 0.5, 24), 1.0, 1, false);
    for (const Mesh& mesh : {tube, insideOut(tube), rounded(turnedInItself(tube, 45.0, {0, 1, 0}))}) {
        const Alone found = aloneIn(renderer(), scenes::sceneOf(mesh));
        SCOPED_TRACE(found.where);
        EXPECT_LE(found.image, 0.5);
        EXPECT_LE(found.turned, 0.5);
        EXPECT_LE(found.exact, 0.5);
    }
}

TEST_P(AxisViews, ofACubeHaveTheirOutlineAllRound) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    for (const double azimuth : {0.0, 45.0, 90.0, 135.0, 180.0, 270.0}) {
        CameraSettings view;
        view.azimuthAngle = azimuth;
        view.elevationAngle = 0.0;
        view.orthographicHeight = 4.0;
        Settings settings;
        settings.picture.size = square;
        settings.lines.from = LinesFrom::Object;
        const std::vector<Ink> ink = inkOf(renderer().lines(scene, frameCamera(scene, view, square), settings));
        const bool diagonal = std::fmod(azimuth, 90.0) != 0.0;
        const double width = diagonal ? 180.0 * std::numbers::sqrt2 : 180.0;
        EXPECT_NEAR(lengthOf(ink, LineType::Outline), 2.0 * (width + 180.0), 0.01) << azimuth;
        EXPECT_NEAR(lengthOf(ink, LineType::Crease), diagonal ? 180.0 : 0.0, 0.01) << azimuth;
    }
}

// Every model of a folder, and what of it one source has alone: a surface seen from its edge has no pixel in image
// space, and image space joins what is nearer than about two pixels. What image space has, object space has.
void expectNoLineOfImageSpaceAlone(Renderer& renderer, const std::filesystem::path& folder,
                                   const std::vector<const char*>& files) {
    for (const char* file : files) {
        if (!std::filesystem::exists(folder / file)) {
            std::printf("[  SKIPPED ] AxisViews: no %s\n", (folder / file).c_str());
            continue;
        }
        const Alone found = aloneIn(renderer, loadScene(folder / file));
        std::printf("%-24s image %5.1f  object %6.1f  turned %5.1f  exact %5.1f  %s\n", file, found.image, found.object,
                    found.turned, found.exact, found.where.c_str());
        EXPECT_LE(found.image, 1.0) << file << ": " << found.where;
        EXPECT_LE(found.turned, 1.0) << file << ": " << found.where;
    }
}

TEST_P(AxisViews, ofAssetsLackNoLine) {
    expectNoLineOfImageSpaceAlone(renderer(), INKEDGE_SOURCE_DIR "/assets",
                                  {"boxes.glb", "bracket.glb", "cube.glb", "gear.glb", "lantern.glb", "primitives.glb",
                                   "sphere.glb", "teapot.glb", "touching_solids.glb", "vase.glb"});
}

TEST_P(AxisViews, ofSharedModelsLackNoLine) {
    const std::filesystem::path folder = std::filesystem::path{INKEDGE_SOURCE_DIR} / "../shared/models";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: no models in ../shared/models";
    expectNoLineOfImageSpaceAlone(renderer(), folder,
                                  {"BoomBox.glb", "Fox.glb", "angle_block_utm.glb", "fandisk.obj", "spot.obj"});
}

}  // namespace
}  // namespace inkedge::render
