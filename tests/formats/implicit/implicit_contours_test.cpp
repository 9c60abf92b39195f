// Contours of implicit surfaces against the surfaces themselves.
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <inkedge/load_scene.h>
#include <inkedge/views.h>

#include "formats/implicit/load_implicit.h"
#include "formats/same_lines.h"
#include "lines/object_lines.h"

namespace inkedge::implicit {
namespace {

struct Known {
    std::string text;
    double (*distance)(glm::dvec3);    // from the surface, near it
    glm::dvec3 (*normal)(glm::dvec3);  // over there
};

const std::vector<Known> known{
    {"bounds -1.2 -1.2 -1.2 1.2 1.2 1.2\nf = x^2 + y^2 + z^2 - 1\n", [](glm::dvec3 p) { return glm::length(p) - 1.0; },
     [](glm::dvec3 p) { return glm::normalize(p); }},
    {"bounds -1.5 -1.5 -0.5 1.5 1.5 0.5\nf = (sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.09\n",
     [](glm::dvec3 p) { return std::hypot(std::hypot(p.x, p.y) - 1.0, p.z) - 0.3; },
     [](glm::dvec3 p) {
         return glm::normalize(p - glm::normalize(glm::dvec3{p.x, p.y, 0.0}));
     }}};

TEST(ImplicitContours, areWhereTheSurfaceTurnsAway) {
    for (const Known& surface : known) {
        for (const bool orthographic : {false, true}) {
            CameraSettings view;
            view.azimuthAngle = 25.0;
            view.elevationAngle = 40.0;
            if (orthographic) view.orthographicHeight = 0.0;
            Settings settings;
            settings.picture.size = {1024, 1024};
            settings.lines.coincident = CoincidentLines::Keep;
            LoadSettings load;
            load.tolerance = 1.0;  // triangles that stray by a pixel
            load.pictures = {{view}, settings.picture, {}};
            const std::vector<std::uint8_t> bytes{surface.text.begin(), surface.text.end()};
            const Scene scene = loadScene(bytes, "form.implicit", load);
            const Camera camera = frameCamera(scene, view, settings.picture.size);
            const glm::dmat4 toWorld = glm::inverse(camera.view);
            const double pixel = 2.0 * scene.bounds().radius / 1024.0;  // at least as wide as a pixel
            double length = 0.0;
            for (const Line& line : lines::ObjectLines{scene}.find(camera, settings).lines) {
                EXPECT_THAT(line.type, testing::AnyOf(LineType::Outline, LineType::Occlusion));
                for (std::size_t i = 0; i < line.points.size(); ++i) {
                    const glm::dvec3 p = line.points[i].position;
                    // Where a part ends that is hidden from there on, its end lies on a straight piece.
                    const bool isEnd = !line.closed && (i == 0 || i + 1 == line.points.size());
                    EXPECT_NEAR(surface.distance(p), 0.0, isEnd ? 0.02 * pixel : 1e-5);
                    const glm::dvec3 seen =
                        camera.orthographic() ? glm::dvec3{-toWorld[2]} : glm::dvec3{toWorld[3]} - p;
                    if (!isEnd) {
                        EXPECT_NEAR(glm::dot(surface.normal(p), glm::normalize(seen)), 0.0, 1e-5);
                    }
                    if (i > 0) length += glm::distance(line.points[i].pixel, line.points[i - 1].pixel);
                }
            }
            EXPECT_GT(length, 2000.0);
        }
    }
}

std::string torusOf(double scale) {
    return fmt::format("bounds {0} {0} {1} {2} {2} {3}\nf = (sqrt(x^2 + y^2) - {4})^2 + z^2 - 0.09*{4}^2\n",
                       -1.5 * scale, -0.5 * scale, 1.5 * scale, 0.5 * scale, scale);
}

LoadSettings ofSmallPicture() {
    LoadSettings load;
    load.pictures.picture.size = {400, 400};
    return load;
}

TEST(ImplicitContours, areTheSameInAnyUnit) {
    const auto linesOf = [](double scale) {
        const std::string text = torusOf(scale);
        return linesToCompare(
            loadScene(std::vector<std::uint8_t>{text.begin(), text.end()}, "form.implicit", ofSmallPicture()));
    };
    const Lines expected = linesOf(1.0);
    ASSERT_GT(expected.lines.size(), 2U);
    for (const double scale : {1e-6, 25.4, 1e6}) {
        SCOPED_TRACE(scale);
        expectSameLines(linesOf(scale), expected, 1e-2);  // positions are floats, and numbers of the file are rounded
    }
}

TEST(ImplicitContours, areThoseOfEachInstance) {
    const std::string text = torusOf(1.0);
    const std::vector<std::uint8_t> bytes{text.begin(), text.end()};
    const Scene::Data one = loadImplicit({"form.implicit", bytes}, ofSmallPicture());
    const auto at = [&](double x, double scale) {
        Instance instance = one.instances.front();
        instance.transform = glm::dmat4{glm::dmat3{scale}};
        instance.transform[3] = {x, 0.0, 0.0, 1.0};
        return instance;
    };
    const auto linesOf = [&](const std::vector<Instance>& instances) {
        Scene::Data data = one;
        data.instances = instances;
        const Scene scene{std::move(data), ofSmallPicture()};
        CameraSettings view;
        view.position = glm::dvec3{1.0, -12.0, 7.0};
        view.focalPoint = glm::dvec3{1.0, 0.0, 0.0};
        Settings settings;
        settings.picture.size = {400, 400};
        return lines::ObjectLines{scene}.find(frameCamera(scene, view, settings.picture.size), settings);
    };
    Lines both = linesOf({at(-1.6, 1.0), at(3.5, 2.0)});
    for (const std::uint32_t object : {1U, 2U}) {
        Lines its = both;
        std::erase_if(its.lines, [&](const Line& line) { return line.object != object; });
        ASSERT_GT(its.lines.size(), 1U);
        expectSameLines(its, linesOf({object == 1 ? at(-1.6, 1.0) : at(3.5, 2.0)}), 1e-3);
    }
}

}  // namespace
}  // namespace inkedge::implicit
