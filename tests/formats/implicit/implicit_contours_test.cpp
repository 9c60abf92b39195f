// Contours of implicit surfaces against the surfaces themselves.
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <inkedge/load_scene.h>
#include <inkedge/views.h>

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

}  // namespace
}  // namespace inkedge::implicit
