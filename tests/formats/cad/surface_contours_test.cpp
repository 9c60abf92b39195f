// Contours on the surfaces of CAD files, against the shapes themselves: a hair beside a line there is nothing.
#include <array>
#include <filesystem>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <inkedge/views.h>

#include "formats/cad/cad_scenes.h"
#include "formats/cad/true_contours.h"
#include "formats/same_lines.h"
#include "lines/object_lines.h"
#include "lines/screen.h"
#include "mesh/topology.h"

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

bool hasRims(Shape shape) { return shape == Shape::Cylinder || shape == Shape::Cone || shape == Shape::SplineCone; }

// Those are creases: polygons, to the tolerance.
bool isOnRim(const Known& known, const LinePoint& a, const LinePoint& b) {
    const auto isNear = [&](double z) {
        return std::abs(a.position.z - z) < 1e-3 && std::abs(b.position.z - z) < 1e-3;
    };
    return hasRims(known.shape) && (isNear(0.0) || isNear(12.0));
}

void expectOutlinesWithin(double pixels, const Known& known, const CameraSettings& view) {
    LoadSettings load;
    Settings settings;
    settings.picture.size = {1024, 1024};
    settings.lines.coincident = CoincidentLines::Keep;  // merged ones stray by up to 0.1 pixels
    load.tolerance = 0.5;
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
    EXPECT_GE(tested, hasRims(known.shape) ? 4 : 100);
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
    std::vector<Known> all = known();
    for (const Known& each : known())
        if (each.shape == Shape::Cone) all.push_back({Shape::SplineCone, each.normal, each.distance});
    for (const Known& known : all) {
        expectOutlinesWithin(0.05, known, iso);
        if (known.shape != Shape::Sphere && !hasRims(known.shape)) continue;  // for speed
        expectOutlinesWithin(0.05, known, perspective);
        expectOutlinesWithin(0.05, known, near);
    }
}

// Those edges of the model that are drawn as polygons, in the world.
std::vector<std::pair<glm::dvec3, glm::dvec3>> drawnEdges(const Scene& scene) {
    std::vector<std::pair<glm::dvec3, glm::dvec3>> edges;
    for (const Instance& instance : scene.instances()) {
        const Mesh& mesh = scene.meshes()[instance.mesh];
        const auto inWorld = [&](std::uint32_t corner) {
            return glm::dvec3{instance.transform * glm::dvec4{position(mesh, corner), 1.0}};
        };
        for (std::uint32_t h = 0; h < mesh.indices.size(); ++h)
            if (mesh.edges[h].has(EdgeKind::Sharp) || mesh.edges[h].has(EdgeKind::Free))
                edges.emplace_back(inWorld(h), inWorld(mesh::nextHalfEdge(h)));
    }
    return edges;
}

bool isOn(const std::vector<std::pair<glm::dvec3, glm::dvec3>>& edges, glm::dvec3 p, double within) {
    return std::ranges::any_of(edges, [&](const auto& edge) {
        const glm::dvec3 along = edge.second - edge.first;
        const double square = glm::dot(along, along);
        const double share = square > 0.0 ? std::clamp(glm::dot(p - edge.first, along) / square, 0.0, 1.0) : 0.0;
        return glm::distance(p, edge.first + share * along) <= within;
    });
}

TEST(SurfaceContours, areThoseThatOpenCascadeHasOfRealParts) {
    const std::filesystem::path folder = std::filesystem::path{INKEDGE_SOURCE_DIR} / "../shared/cad";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: no files in ../shared/cad";
    for (const std::string name : {"nist_ctc_01_ap203.stp", "nist_ctc_02_ap203.stp", "nist_ctc_03_ap203.stp"}) {
        const cad_files::TrueContours contours{folder / name};
        for (const bool orthographic : {false, true}) {
            SCOPED_TRACE(name + (orthographic ? ", orthographic" : ""));
            CameraSettings view;
            view.azimuthAngle = 37.0;
            view.elevationAngle = 29.0;
            if (orthographic) view.orthographicHeight = 0.0;
            LoadSettings load;
            Settings settings;
            settings.picture.size = {1024, 1024};
            settings.lines.coincident = CoincidentLines::Keep;
            load.pictures = {{view}, settings.picture, {}};
            const Scene scene = loadScene(folder / name, load);
            const Camera camera = frameCamera(scene, view, settings.picture.size);
            const glm::dmat4 toWorld = glm::inverse(camera.view);
            const cad_files::TrueContours::Eye eye{orthographic, glm::dvec3{toWorld[3]}, -glm::dvec3{toWorld[2]}};
            const lines::Screen screen{camera, scene.bounds().centre, settings.picture.size};
            const auto edges = drawnEdges(scene);
            int tested = 0;
            double farthest = 0.0;
            for (const Line& line : lines::ObjectLines{scene}.find(camera, settings).lines) {
                if (line.type != LineType::Outline && line.type != LineType::Occlusion) continue;
                for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
                    const glm::dvec3 a = line.points[i].position;
                    const glm::dvec3 b = line.points[i + 1].position;
                    const double pixel = screen.footprint(0.5 * (a + b) - scene.bounds().centre);
                    if (isOn(edges, 0.5 * (a + b), 1e-3 * pixel)) continue;
                    for (const glm::dvec3 p : {a, 0.5 * (a + b), b}) {
                        const double off = contours.offsetOf(p, eye, 3.0 * pixel) / pixel;
                        farthest = std::max(farthest, off);
                        ++tested;
                    }
                }
            }
            EXPECT_GT(tested, 40);
            EXPECT_LE(farthest, 0.05);
        }
    }
}

TEST(SurfaceContours, areTheSameInAnyUnit) {
    const auto linesOf = [](double scale) {
        LoadSettings load;
        load.pictures.picture.size = {400, 400};
        return linesToCompare(sceneOf(cad_files::scaledStep(Shape::Torus, scale), "part.step", load));
    };
    const Lines expected = linesOf(1.0);
    ASSERT_GT(expected.lines.size(), 2U);
    for (const double scale : {1e-6, 1e-3, 25.4, 1e3, 1e6}) {
        SCOPED_TRACE(scale);
        expectSameLines(linesOf(scale), expected, 0.04);  // triangles differ: straight pieces may stray by 0.02 each
    }
}

TEST(SurfaceContours, areThoseOfEachInstance) {
    // The torus, and itself mirrored and twice as large about (-5, 0, 0).
    const std::string text = mapped("#9021,#9022,#9023,2.,#9012", Shape::Torus);
    const Known& torus = *std::ranges::find(known(), Shape::Torus, &Known::shape);
    LoadSettings load;
    Settings settings;
    settings.picture.size = {400, 400};
    load.pictures = {{CameraSettings{}}, settings.picture, {}};
    const Scene scene = sceneOf(text, "part.step", load);
    const Camera camera = frameCamera(scene, {}, settings.picture.size);
    const glm::dvec3 eye{glm::inverse(camera.view)[3]};
    std::array<int, 2> tested{};
    for (const Line& line : lines::ObjectLines{scene}.find(camera, settings).lines) {
        if (line.type != LineType::Outline && line.type != LineType::Occlusion) continue;
        const bool isSecond = line.object == 2;
        for (std::size_t i = 1; i + 1 < line.points.size(); ++i) {  // parts that are hidden cut straight pieces
            const glm::dvec3 world = line.points[i].position;
            const glm::dvec3 p = isSecond ? 0.5 * (world - glm::dvec3{-5.0, 0.0, 0.0}) : world;
            EXPECT_NEAR(torus.distance(p), 0.0, 1e-4);
            EXPECT_NEAR(glm::dot(torus.normal(p), glm::normalize(world - eye)), 0.0, 1e-4);
            ++tested[isSecond ? 1 : 0];
        }
    }
    EXPECT_GT(tested[0], 20);
    EXPECT_GT(tested[1], 50);
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
