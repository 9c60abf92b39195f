// Two solids of a STEP file that run into each other: where they meet is a line, and the lines of each end there.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/views.h>

#include "formats/cad/cad_scenes.h"
#include "gl/gl_test.h"

namespace inkedge::cad {
namespace {

INKEDGE_ON_EACH_BACKEND(CrossingSolids);

constexpr double radius = 4.0;  // of the cylinder about (x, 10, 15)
constexpr double side = 10.0;   // of the box, the one at x = 10, from which the cylinder sticks out

double fromAxis(glm::dvec3 p) { return std::hypot(p.y - 10.0, p.z - 15.0); }

// How deep a point lies in one of the solids.
double depthIn(glm::dvec3 p) {
    const double inBox = std::min({p.x, side - p.x, p.y, 20.0 - p.y, p.z, 30.0 - p.z});
    const double inCylinder = std::min({radius - fromAxis(p), p.x + 10.0, 20.0 - p.x});
    return std::max(inBox, inCylinder);
}

struct Found {
    double crossing = 0.0;  // the length in space of intersections that are seen
    double furthest = 0.0;  // of their points from the circle
    double deepest = 0.0;   // of points of lines that are seen
};

Found foundIn(const Lines& lines) {
    Found found;
    for (const Line& line : lines.lines) {
        if (!line.visible) continue;
        for (std::size_t i = 0; i < line.points.size(); ++i) {
            const glm::dvec3 p = line.points[i].position;
            found.deepest = std::max(found.deepest, depthIn(p));
            if (line.type != LineType::Intersection) continue;
            found.furthest = std::max(found.furthest, std::hypot(p.x - side, fromAxis(p) - radius));
            if (i > 0) found.crossing += glm::distance(line.points[i - 1].position, p);
        }
    }
    return found;
}

// In the view from (1, -1, 1): of the circle in which the box's side cuts the cylinder, the cylinder hides one half.
void expectALine(Renderer& renderer, const std::string& text, const std::string& name, std::size_t instances) {
    SCOPED_TRACE(name);
    Settings settings;
    settings.picture.size = {800, 800};
    CameraSettings iso;
    iso.view = NamedView::Iso;
    LoadSettings load;
    load.pictures = {{iso}, settings.picture, {}};
    const Scene scene = sceneOf(text, name, load);
    ASSERT_EQ(scene.instances().size(), instances);
    const Camera camera = frameCamera(scene, iso, settings.picture.size);
    const double pixel = camera.orthographicHeight / settings.picture.size.height;
    // Image space knows a line to a pixel across, which is several on a surface that is seen from the side.
    for (const auto& [from, within] : {std::pair{LinesFrom::Object, 1.0}, std::pair{LinesFrom::Image, 4.0}}) {
        SCOPED_TRACE(from == LinesFrom::Object ? "object" : "image");
        RenderSettings render;
        render.picture = settings.picture;
        render.lines.from = from;
        const Found found = foundIn(renderer.lines(scene, camera, render));
        EXPECT_LT(found.furthest, within * pixel);
        EXPECT_LT(found.deepest, within * pixel);
        EXPECT_NEAR(found.crossing, std::numbers::pi * radius, 4.0 * within * pixel);
    }
}

TEST_P(CrossingSolids, haveALineWhereTheyMeetAndNoneInEachOther) {
    expectALine(renderer(), cad_files::step(Shape::Crossing), "part.step", 2);
    expectALine(renderer(), cad_files::brep(Shape::Crossing), "part.brep", 1);
}

}  // namespace
}  // namespace inkedge::cad
