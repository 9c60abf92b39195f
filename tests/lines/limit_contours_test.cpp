// Contours of subdivided meshes against those of tiny triangles on the same limit surface.
#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <glm/geometric.hpp>

#include <inkedge/views.h>

#include "formats/same_lines.h"
#include "lines/object_lines.h"
#include "lines/screen.h"
#include "mesh/control_mesh.h"
#include "mesh/control_meshes.h"
#include "mesh/subdivision.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

using namespace control_meshes;

struct Case {
    std::string name;
    Mesh control;
    double creaseAngle;
    int fine;  // levels at which triangles are a few pixels large
};

// A sheet with a bulge: contours that end at its border.
Mesh bulge() {
    Mesh mesh = grid(4);
    for (glm::vec3& p : mesh.positions) p.z = 1.4F * (1.0F - p.x * p.x) * (1.0F - 0.5F * p.y);
    return mesh;
}

std::vector<Case> cases() {
    return {{"cube", quadCube(), smoothAngle, 8},
            {"cube of triangles", asTriangles(quadCube()), smoothAngle, 8},
            {"torus", torus(8, 6), smoothAngle, 6},
            {"torus of triangles", asTriangles(torus(8, 6)), smoothAngle, 6},
            {"torus with creases", asTriangles(torus(16, 10)), 25.0, 6},
            {"sheet", bulge(), smoothAngle, 7}};
}

using Piece = std::pair<glm::dvec2, glm::dvec2>;

// Hertzmann 1999, equations 2 to 4.
std::vector<Piece> finePieces(const Case& c, const Screen& screen, glm::dvec3 centre) {
    const Scene coarse = refined(c.control, levels(0, c.creaseAngle));
    const mesh::ControlMesh control = mesh::controlMesh(coarse.meshes()[0], scene::topologyOf(coarse, 0));
    const mesh::RefinedFaces fine =
        modules::functionsOf<mesh::subdivisionModule>(Error::Kind::Runtime).refine(control, c.fine);
    const std::size_t size = control.scheme == mesh::SubdivisionScheme::Loop ? 3 : 4;
    const auto viewDot = [&](std::uint32_t v) {
        return glm::dot(fine.normals[v], screen.ray(fine.positions[v] - centre));
    };
    const auto pixel = [&](glm::dvec3 p) { return screen.project(p - centre).pixel; };
    std::vector<Piece> pieces;
    for (std::size_t f = 0; f < fine.parents.size(); ++f) {
        std::vector<glm::dvec2> crossings;
        for (std::size_t k = 0; k < size; ++k) {
            const std::uint32_t a = fine.corners[size * f + k];
            const std::uint32_t b = fine.corners[size * f + (k + 1) % size];
            const double atA = viewDot(a);
            const double atB = viewDot(b);
            if ((atA < 0.0) != (atB < 0.0))
                crossings.push_back(pixel((atB * fine.positions[a] - atA * fine.positions[b]) / (atB - atA)));
        }
        for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) pieces.emplace_back(crossings[i], crossings[i + 1]);
    }
    return pieces;
}

double distanceTo(const std::vector<Piece>& pieces, glm::dvec2 p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : pieces) {
        const glm::dvec2 along = b - a;
        const double square = glm::dot(along, along);
        const double share = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
        const glm::dvec2 off = p - a - share * along;
        nearest = std::min(nearest, glm::dot(off, off));
    }
    return std::sqrt(nearest);
}

// Those edges that are drawn as they are.
std::vector<Piece> sharpEdges(const Scene& scene, const Screen& screen, glm::dvec3 centre) {
    const Mesh& mesh = scene.meshes()[0];
    const mesh::MeshTopology& topology = scene::topologyOf(scene, 0);
    std::vector<Piece> pieces;
    for (std::uint32_t h = 0; h < mesh.indices.size(); ++h)
        if (topology.creases[h] || !mesh::isHalfEdge(topology.twins[h]))
            pieces.emplace_back(screen.project(corner(mesh, h) - centre).pixel,
                                screen.project(corner(mesh, mesh::nextHalfEdge(h)) - centre).pixel);
    return pieces;
}

CameraSettings viewOf(bool orthographic) {
    CameraSettings view;
    view.azimuthAngle = 33.0;
    view.elevationAngle = 27.0;
    if (orthographic) view.orthographicHeight = 0.0;
    return view;
}

Settings settingsOf(int adaptive) {
    Settings settings;
    settings.picture.size = {1024, 1024};
    settings.lines.coincident = CoincidentLines::Keep;  // merged ones stray by up to 0.1 pixels
    settings.lines.subdivideAdaptive = adaptive;
    return settings;
}

// The farthest that a smooth contour strays, at its points and between them; -1: there is none.
double strayOf(const Case& c, bool orthographic, int level, int adaptive) {
    const Scene scene = refined(c.control, levels(level, c.creaseAngle));
    const Settings settings = settingsOf(adaptive);
    const Camera camera = frameCamera(scene, viewOf(orthographic), settings.picture.size);
    const glm::dvec3 centre = scene.bounds().centre;
    const Screen screen{camera, centre, settings.picture.size};
    const std::vector<Piece> fine = finePieces(c, screen, centre);
    const std::vector<Piece> sharp = sharpEdges(scene, screen, centre);
    double farthest = -1.0;
    for (const Line& line : ObjectLines{scene}.find(camera, settings).lines) {
        if (line.type != LineType::Outline && line.type != LineType::Occlusion) continue;
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
            const glm::dvec2 a = line.points[i].pixel;
            const glm::dvec2 b = line.points[i + 1].pixel;
            // Where the contour goes on along such an edge the two are joined over a gap of about a pixel.
            if (std::min(distanceTo(sharp, a), distanceTo(sharp, b)) < 1e-3) continue;
            for (const glm::dvec2 p : {a, 0.5 * (a + b)}) farthest = std::max(farthest, distanceTo(fine, p));
        }
    }
    return farthest;
}

constexpr double allowed = 0.03;  // pixels: 0.02, and what fine triangles stray

TEST(LimitContours, areThoseOfTheLimitSurface) {
    for (const Case& c : cases()) {
        for (const bool orthographic : {false, true}) {
            for (const int level : {1, 3}) {
                SCOPED_TRACE(c.name + (orthographic ? ", orthographic, " : ", ") + std::to_string(level));
                const double stray = strayOf(c, orthographic, level, 0);
                EXPECT_GE(stray, 0.0);
                EXPECT_LE(stray, allowed);
            }
        }
    }
}

LoadSettings rounded() { return levels(2, smoothAngle); }

TEST(LimitContours, areTheSameInAnyUnit) {
    const auto linesOf = [](double scale) {
        Mesh control = torus(8, 6);
        for (glm::vec3& p : control.positions) p = glm::vec3{scale * glm::dvec3{p}};
        return linesToCompare(refined(control, rounded()));
    };
    const Lines expected = linesOf(1.0);
    ASSERT_GT(expected.lines.size(), 2U);
    for (const double scale : {1e-6, 25.4, 1e6}) {
        SCOPED_TRACE(scale);
        expectSameLines(linesOf(scale), expected, 1e-2);  // positions are floats
    }
}

TEST(LimitContours, areThoseOfEachInstance) {
    const auto at = [](double x, double scale) {
        return std::pair{torus(8, 6), scenes::translation({x, 0.0, 0.0}) * scenes::scaling({scale, scale, -scale})};
    };
    const auto linesOf = [](const std::vector<std::pair<Mesh, glm::dmat4>>& instances) {
        const Scene scene = scenes::sceneOf(instances, rounded());
        CameraSettings view;
        view.position = glm::dvec3{1.0, -12.0, 7.0};
        view.focalPoint = glm::dvec3{1.0, 0.0, 0.0};
        Settings settings;
        settings.picture.size = {400, 400};
        return ObjectLines{scene}.find(frameCamera(scene, view, settings.picture.size), settings);
    };
    const Lines both = linesOf({at(-1.6, 1.0), at(3.5, 2.0)});
    for (const std::uint32_t object : {1U, 2U}) {
        Lines its = both;
        std::erase_if(its.lines, [&](const Line& line) { return line.object != object; });
        ASSERT_GT(its.lines.size(), 1U);
        expectSameLines(its, linesOf({object == 1 ? at(-1.6, 1.0) : at(3.5, 2.0)}), 1e-3);
    }
}

TEST(LimitContours, areThoseOfTheLimitSurfaceWhereItAloneIsRefined) {
    for (const Case& c : cases()) {
        SCOPED_TRACE(c.name);
        const double stray = strayOf(c, false, 0, 2);
        EXPECT_GE(stray, 0.0);
        EXPECT_LE(stray, allowed);
    }
}

}  // namespace
}  // namespace inkedge::lines
