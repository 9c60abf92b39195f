#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/load_scene.h>
#include <inkedge/scene.h>

#include "lines/views.h"

namespace inkedge::lines {
namespace {

using namespace scenes;
using namespace views;

// All triangles of a scene in world space; every ray asks every one of them.
class Judge {
public:
    Judge(const Scene& scene, const Camera& camera) : camera_{camera} {
        const glm::dmat4 back = glm::inverse(camera.view);
        eye_ = glm::dvec3{back[3]};
        forward_ = -glm::normalize(glm::dvec3{back[2]});
        for (const Instance& instance : scene.instances()) {
            const Mesh& mesh = scene.meshes()[instance.mesh];
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                std::array<glm::dvec3, 3> t;
                for (std::size_t k = 0; k < 3; ++k)
                    t[k] = glm::dvec3{instance.transform *
                                      glm::dvec4{mesh.origin + glm::dvec3{mesh.positions[mesh.indices[i + k]]}, 1.0}};
                triangles_.push_back({t[0], t[1] - t[0], t[2] - t[0], glm::cross(t[1] - t[0], t[2] - t[0])});
            }
        }
    }

    // Whether a face is nearer than a point by over a share of its distance. What hides by less is the point's own
    // face, for positions are floats and lines lie on faces.
    [[nodiscard]] bool hides(glm::dvec3 point) const {
        constexpr double own = 2e-5;
        const glm::dvec3 from = camera_.orthographic() ? point - forward_ * glm::dot(point - eye_, forward_) : eye_;
        const glm::dvec3 ray = point - from;
        for (const Triangle& t : triangles_) {  // Cramer's rule for from + s ray = a + u e + v f
            const double d = -glm::dot(ray, t.normal);
            if (d == 0.0) continue;
            const glm::dvec3 off = from - t.a;
            const double s = glm::dot(off, t.normal) / d;
            if (s <= 1e-9 || s >= 1.0 - own) continue;
            const glm::dvec3 q = glm::cross(off, ray);
            const double u = glm::dot(t.f, q) / d;
            const double v = -glm::dot(t.e, q) / d;
            if (u >= 0.0 && v >= 0.0 && u + v <= 1.0) return true;
        }
        return false;
    }

    [[nodiscard]] bool faces(const std::array<glm::dvec3, 3>& t) const {
        const glm::dvec3 view = camera_.orthographic() ? forward_ : t[0] - eye_;
        return glm::dot(glm::cross(t[1] - t[0], t[2] - t[0]), view) < 0.0;
    }

private:
    struct Triangle {
        glm::dvec3 a, e, f, normal;
    };
    Camera camera_;
    glm::dvec3 eye_;
    glm::dvec3 forward_;
    std::vector<Triangle> triangles_;
};

struct Piece {
    glm::dvec3 a;
    glm::dvec3 b;
};

// Edges that are lines, if they are seen: between a front and a back face, of one face, or bent by more than the angle;
// found by the positions of their ends. The scene has one sheet of surface at each position: no seams.
std::vector<Piece> linesOfEdges(const Scene& scene, const Judge& judge) {
    struct Faces {
        Piece piece;
        std::vector<bool> front;
        bool inner = false;  // of a polygon
        std::vector<glm::dvec3> normals;
    };
    std::vector<Piece> pieces;
    const double flat = std::cos(glm::radians(scene.creaseAngle() + 1.0));
    for (const Instance& instance : scene.instances()) {
        const Mesh& mesh = scene.meshes()[instance.mesh];
        std::map<std::array<std::array<float, 3>, 2>, Faces> edges;
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            std::array<glm::dvec3, 3> world;
            std::array<std::array<float, 3>, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::vec3 p = mesh.positions[mesh.indices[i + k]];
                for (std::size_t axis = 0; axis < 3; ++axis)  // seams of revolution close but for a rounding
                    corners[k][axis] = std::round(p[static_cast<int>(axis)] * 65536.0F) + 0.0F;
                world[k] = glm::dvec3{instance.transform * glm::dvec4{mesh.origin + glm::dvec3{p}, 1.0}};
            }
            const glm::dvec3 normal = glm::cross(world[1] - world[0], world[2] - world[0]);
            if (glm::length(normal) == 0.0) continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                Faces& faces =
                    edges[std::array{std::min(corners[k], corners[next]), std::max(corners[k], corners[next])}];
                faces.piece = {world[k], world[next]};
                faces.inner = faces.inner || (!mesh.edges.empty() && mesh.edges[i + k].has(EdgeKind::Inner));
                faces.front.push_back(judge.faces(world));
                faces.normals.push_back(glm::normalize(normal));
            }
        }
        for (const auto& [ends, faces] : edges) {
            const bool single = faces.front.size() == 1;
            const bool contour = faces.front.size() == 2 && faces.front[0] != faces.front[1];
            const bool crease =
                !faces.inner && faces.front.size() == 2 && glm::dot(faces.normals[0], faces.normals[1]) < flat;
            if (single || contour || crease) pieces.push_back(faces.piece);
        }
    }
    return pieces;
}

constexpr double sampleEvery = 0.25;  // pixels

template <class Visit>
void sample(glm::dvec2 a, glm::dvec2 b, Visit visit) {
    const int count = std::max(1, static_cast<int>(glm::distance(a, b) / sampleEvery));
    for (int i = 0; i < count; ++i) visit((i + 0.5) / count);
}

// Which pixels have a drawn line within a distance; cells as wide as that.
class Drawn {
public:
    Drawn(Size size, double reach) : size_{size}, reach_{reach} {}
    void add(glm::dvec2 p) { cells_[cellOf(p)].push_back(p); }
    [[nodiscard]] bool near(glm::dvec2 p) const {
        const auto [x, y] = cellOf(p);
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                const auto cell = cells_.find({x + dx, y + dy});
                if (cell == cells_.end()) continue;
                for (const glm::dvec2& q : cell->second)
                    if (glm::distance(p, q) <= reach_) return true;
            }
        }
        return false;
    }
    [[nodiscard]] bool inside(glm::dvec2 p) const {
        return p.x > 1 && p.y > 1 && p.x < size_.width - 1 && p.y < size_.height - 1;
    }

private:
    [[nodiscard]] std::pair<int, int> cellOf(glm::dvec2 p) const {
        return {static_cast<int>(std::floor(p.x / reach_)), static_cast<int>(std::floor(p.y / reach_))};
    }
    Size size_;
    double reach_;
    std::map<std::pair<int, int>, std::vector<glm::dvec2>> cells_;
};

// Sums over views.
struct Measured {
    int drawn = 0;        // samples of seen lines
    int drawnHidden = 0;  // of these, hidden in truth
    int seen = 0;         // samples of edges that are seen in truth
    int missed = 0;       // of these, without a line
    int ends = 0;         // of seen lines where a hidden one goes on
    int wrongEnds = 0;    // of these, those where a pixel on it is not hidden, or a pixel back not seen
    [[nodiscard]] double hiddenShare() const { return double(drawnHidden) / std::max(1, drawn); }
    [[nodiscard]] double missedShare() const { return double(missed) / std::max(1, seen); }
    [[nodiscard]] double wrongEndShare() const { return double(wrongEnds) / std::max(1, ends); }
};

// Along a line by a length in the picture.
glm::dvec3 along(const Line& line, bool fromEnd, double pixels) {
    std::vector<LinePoint> points = line.points;
    if (fromEnd) std::ranges::reverse(points);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double piece = glm::distance(points[i].pixel, points[i + 1].pixel);
        if (piece >= pixels && piece > 0.0)
            return points[i].position + pixels / piece * (points[i + 1].position - points[i].position);
        pixels -= piece;
    }
    return points.back().position;
}

void measureEnds(const std::vector<Line>& lines, const Judge& judge, Measured& to) {
    constexpr double reach = 1.0;  // pixels
    for (const Line& seen : lines) {
        if (!seen.visible || seen.closed) continue;
        for (const Line& hidden : lines) {
            if (hidden.visible || hidden.closed) continue;
            for (const bool end : {false, true}) {
                for (const bool hiddenEnd : {false, true}) {
                    const glm::dvec3 p = end ? seen.points.back().position : seen.points.front().position;
                    const glm::dvec3 q = hiddenEnd ? hidden.points.back().position : hidden.points.front().position;
                    if (p != q) continue;
                    ++to.ends;
                    const bool right = !judge.hides(along(seen, end, std::min(reach, 0.5 * length(seen)))) &&
                                       judge.hides(along(hidden, hiddenEnd, std::min(reach, 0.5 * length(hidden))));
                    to.wrongEnds += right ? 0 : 1;
                }
            }
        }
    }
}

void measure(const Scene& scene, const Camera& camera, Measured& to) {
    constexpr double reach = 1.0;  // pixels
    const LineOptions options{.size = {240, 180}, .contour = Contour::Mesh, .hidden = HiddenLines::Solid};
    const Judge judge{scene, camera};
    const auto lines = linesOf(scene, camera, options);
    Drawn drawn{options.size, reach};
    for (const Line& line : lines) {
        if (!line.visible) continue;
        forEachPiece(line, [&](const LinePoint& p, const LinePoint& q) {
            sample(p.pixel, q.pixel, [&](double s) {
                const glm::dvec2 at = p.pixel + s * (q.pixel - p.pixel);
                drawn.add(at);
                if (!drawn.inside(at)) return;
                ++to.drawn;
                // The point between p and q that the picture shows there: on the ray, so by depths.
                const double a = (camera.view * glm::dvec4{p.position, 1}).z;
                const double b = (camera.view * glm::dvec4{q.position, 1}).z;
                const double t = camera.orthographic() ? s : s * a / (s * a + (1 - s) * b);
                to.drawnHidden += judge.hides(p.position + t * (q.position - p.position)) ? 1 : 0;
            });
        });
    }
    for (const Piece& piece : linesOfEdges(scene, judge)) {
        sample(pixel(camera, options.size, piece.a), pixel(camera, options.size, piece.b), [&](double t) {
            const glm::dvec3 point = piece.a + t * (piece.b - piece.a);
            const glm::dvec2 at = pixel(camera, options.size, point);
            if (!drawn.inside(at) || judge.hides(point)) return;
            ++to.seen;
            to.missed += drawn.near(at) ? 0 : 1;
        });
    }
    measureEnds(lines, judge, to);
}

Measured measureAround(const Scene& scene) {
    Measured measured;
    const Sphere ball = scene.bounds();
    for (const glm::dvec3 from : {glm::dvec3{5, 3, 7}, {-6, 2, 1}, {1, -4, -3}}) {
        const glm::dvec3 eye = ball.centre + 4.0 * ball.radius * glm::normalize(from);
        Camera camera = perspective(eye, ball.centre);
        camera.near = 0.1 * ball.radius;
        measure(scene, camera, measured);
    }
    measure(scene, orthographic(ball.centre + ball.radius * glm::dvec3{-2, 2, 3}, 2.0 * ball.radius, ball.centre),
            measured);
    return measured;
}

// The promises of the paper's section 3.4 as this project holds them. Of what is drawn up to 1.5 % may be hidden: gaps
// of up to 2.5 pixels between seen parts are filled on purpose. Of what is seen next to nothing may miss: parts under a
// pixel. Of the ends where a line goes on hidden up to 5 % may be off by over a pixel, most by the same gaps.
void expectTrue(const char* name, const Scene& scene) {
    const Measured m = measureAround(scene);
    std::printf("%-24s drawn %6d hidden %.3f %%, seen %6d missed %.3f %%, ends %4d wrong %.1f %%\n", name, m.drawn,
                100.0 * m.hiddenShare(), m.seen, 100.0 * m.missedShare(), m.ends, 100.0 * m.wrongEndShare());
    EXPECT_GT(m.drawn, 1000) << name;
    EXPECT_LE(m.hiddenShare(), 0.015) << name;
    EXPECT_GT(m.seen, 1000) << name;
    EXPECT_LE(m.missedShare(), 0.005) << name;
    EXPECT_LE(m.wrongEndShare(), 0.05) << name;
}

TEST(Visibility, OfAssetsIsThatOfEveryRayAndEveryTriangle) {
    for (const char* file : {"cube.glb", "boxes.glb", "bracket.glb", "folded_paper.glb", "gear.glb", "sheet.glb"})
        expectTrue(file, loadScene(std::filesystem::path{INKEDGE_SOURCE_DIR} / "assets" / file));
}

TEST(Visibility, OfMadeShapesIsThatOfEveryRayAndEveryTriangle) {
    expectTrue("sphere", sceneOf(sphere(1.0, 32)));
    expectTrue("torus", sceneOf(torus(2.0, 0.8, 60, 24)));
    Mesh wave = sheet(4.0, 24);
    for (glm::vec3& p : wave.positions) p.y = 0.4F * std::sin(3.0F * p.x) * std::cos(2.0F * p.z);
    expectTrue("wave", sceneOf(wave));
    std::vector<std::pair<Mesh, glm::dmat4>> many;
    for (int i = 0; i < 12; ++i)
        many.emplace_back(i % 3 == 0 ? sphere(0.6, 16) : box({0.8, 1.1, 0.5}),
                          translation({std::sin(5.0 * i) * 2.0, std::cos(3.0 * i) * 2.0, std::sin(2.0 * i + 1) * 2.0}) *
                              rotation(37.0 * i, {1, 2, 3}));
    expectTrue("many", sceneOf(many));
}

TEST(Visibility, OfSharedModelsIsThatOfEveryRayAndEveryTriangle) {
    const std::filesystem::path folder = std::filesystem::path{INKEDGE_SOURCE_DIR} / "../shared/models";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "SKIPPED: no models in ../shared/models";
    for (const char* file : {"suzanne.obj", "angle_block_utm.glb"}) {
        if (!std::filesystem::exists(folder / file)) {
            std::printf("SKIPPED: no %s in ../shared/models\n", file);
            continue;
        }
        LoadSettings settings;
        settings.creases = Creases::Angle;  // what linesOfEdges() takes for a crease
        expectTrue(file, loadScene(folder / file, settings));
    }
}

}  // namespace
}  // namespace inkedge::lines
