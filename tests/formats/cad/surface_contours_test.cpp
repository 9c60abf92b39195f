// Contours on the surfaces of CAD files, against the shapes themselves: a hair beside a line there is nothing.
#include <numbers>
#include <utility>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <inkedge/views.h>

#include "formats/cad/cad_scenes.h"
#include "lines/object_lines.h"

namespace inkedge::cad {
namespace {

// The nearest that a ray comes to a shape; below 0 where it enters the shape.
double clearance(const Known& known, const Camera& camera, Size size, glm::dvec2 pixel) {
    const glm::dmat4 toWorld = glm::inverse(camera.view);
    const double half = camera.orthographic() ? 0.5 * camera.orthographicHeight
                                              : std::tan(0.5 * camera.viewAngle * std::numbers::pi / 180.0);
    const double aspect = static_cast<double>(size.width) / size.height;
    const glm::dvec2 at{(2.0 * pixel.x / size.width - 1.0) * half * aspect, (1.0 - 2.0 * pixel.y / size.height) * half};
    const glm::dvec3 from = camera.orthographic() ? glm::dvec3{at, 0.0} : glm::dvec3{0.0};
    const glm::dvec3 along = camera.orthographic() ? glm::dvec3{0, 0, -1} : glm::normalize(glm::dvec3{at, -1.0});
    const glm::dvec3 start{toWorld * glm::dvec4{from, 1.0}};
    const glm::dvec3 direction = glm::dmat3{toWorld} * along;
    double nearest = 1e9;
    for (double way = 0.9 * camera.near; way < camera.far;) {  // hardly a step enters the shape
        const double distance = known.distance(start + way * direction);
        nearest = std::min(nearest, distance);
        if (distance < 0.0) break;
        way += std::max(distance, 1e-3);
    }
    return nearest;
}

// Those of the cylinder are creases: polygons, to the tolerance.
bool isOnRim(const Known& known, const LinePoint& a, const LinePoint& b) {
    const auto isNear = [&](double z) {
        return std::abs(a.position.z - z) < 1e-3 && std::abs(b.position.z - z) < 1e-3;
    };
    return known.shape == Shape::Cylinder && (isNear(0.0) || isNear(12.0));
}

void expectOutlinesWithin(double pixels, const Known& known, const CameraSettings& view) {
    LoadSettings load;
    Settings settings;
    settings.picture.size = {1024, 1024};
    settings.lines.coincident = CoincidentLines::Keep;  // merged ones stray by up to 0.1 pixels
    load.pictures = {{view}, settings.picture, {}};
    const Scene scene = sceneOf(known.shape, load);
    const Camera camera = frameCamera(scene, view, settings.picture.size);
    const Lines found = lines::ObjectLines{scene}.find(camera, settings);
    int tested = 0;
    int wrong = 0;
    glm::dvec2 where{0.0};
    for (const Line& line : found.lines) {
        if (line.type != LineType::Outline) continue;
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const glm::dvec2 a = line.points[i].pixel;
            const glm::dvec2 b = line.points[i + 1].pixel;
            if (glm::distance(a, b) < 0.5 || isOnRim(known, line.points[i], line.points[i + 1])) continue;
            const glm::dvec2 across = pixels * glm::normalize(glm::dvec2{a.y - b.y, b.x - a.x});
            for (const double share : {0.05, 0.5}) {
                const glm::dvec2 at = a + share * (b - a);
                // Where lines end, at corners and cusps, another part of the shape lies beside them.
                const auto isNear = [&](const LinePoint& end) { return glm::distance(end.pixel, at) < 8.0; };
                if (!line.closed && (isNear(line.points.front()) || isNear(line.points.back()))) continue;
                const double one = clearance(known, camera, settings.picture.size, at + across);
                const double other = clearance(known, camera, settings.picture.size, at - across);
                ++tested;
                if ((one < 0.0) != (other < 0.0)) continue;
                ++wrong;
                where = at;
            }
        }
    }
    EXPECT_GE(tested, known.shape == Shape::Cylinder ? 4 : 100);
    EXPECT_EQ(wrong, 0) << "of " << tested << ", shape " << static_cast<int>(known.shape) << ", last at " << where.x
                        << ", " << where.y;
}

TEST(SurfaceContours, areThoseOfTheSurfaces) {
    CameraSettings perspective;
    CameraSettings near;
    near.position = glm::dvec3{14, -9, 8};
    near.focalPoint = glm::dvec3{0, 0, 1};
    CameraSettings iso;
    iso.view = NamedView::Iso;
    for (const Known& known : known()) {
        expectOutlinesWithin(0.05, known, iso);
        if (known.shape == Shape::SplineTorus || known.shape == Shape::Torus) continue;  // for speed
        expectOutlinesWithin(0.05, known, perspective);
        expectOutlinesWithin(0.05, known, near);
    }
}

TEST(SurfaceContours, areOneClosedLineAroundAWholeShape) {
    CameraSettings view;
    view.view = NamedView::Iso;
    for (const Shape shape : {Shape::Sphere, Shape::Torus}) {
        LoadSettings load;
        Settings settings;
        settings.picture.size = {512, 512};
        load.pictures = {{view}, settings.picture, {}};
        const Scene scene = sceneOf(shape, load);
        const Lines found = lines::ObjectLines{scene}.find(frameCamera(scene, view, settings.picture.size), settings);
        const auto outlines =
            std::ranges::count_if(found.lines, [](const Line& line) { return line.type == LineType::Outline; });
        EXPECT_LE(outlines, shape == Shape::Sphere ? 1 : 4) << static_cast<int>(shape);
        if (shape != Shape::Sphere) continue;
        EXPECT_TRUE(found.lines.front().closed);
        for (const LinePoint& point : found.lines.front().points) {
            EXPECT_NEAR(glm::length(point.position), 4.0, 1e-4);
            EXPECT_NEAR(glm::distance(point.pixel, glm::dvec2{256.0}), 0.46 * 512.0, 0.05);
        }
    }
}

}  // namespace
}  // namespace inkedge::cad
