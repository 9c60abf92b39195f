#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>

#include <inkedge/camera.h>
#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "lines/object_lines.h"
#include "lines/screen.h"
#include "scenes.h"

/// Cameras for lines, and sums over what they see.
namespace inkedge::lines::views {

inline Camera perspective(glm::dvec3 eye, glm::dvec3 at = glm::dvec3{0.0}, double viewAngle = 35.0) {
    Camera camera;
    const bool alongY = std::abs(glm::normalize(at - eye).y) > 0.99;
    camera.view = glm::lookAt(eye, at, alongY ? glm::dvec3{0, 0, -1} : glm::dvec3{0, 1, 0});
    camera.viewAngle = viewAngle;
    camera.near = 0.01;
    camera.far = 1000.0;
    return camera;
}

inline Camera orthographic(glm::dvec3 eye, double height, glm::dvec3 at = glm::dvec3{0.0}) {
    Camera camera = perspective(eye, at);
    camera.orthographicHeight = height;
    return camera;
}

inline constexpr std::array bothContours{Contour::Mesh, Contour::Smooth};

struct LineOptions {
    Size size{400, 300};
    Contour contour = Contour::Auto;
    HiddenLines hidden = HiddenLines::None;
};

inline Settings settingsOf(const LineOptions& options) {
    Settings settings;
    settings.picture.size = options.size;
    settings.picture.lines = standardLineTypes;
    settings.lines.contour = options.contour;
    settings.lines.hidden = options.hidden;
    return settings;
}

inline std::vector<Line> linesOf(const Scene& scene, const Camera& camera, const LineOptions& options = {}) {
    return ObjectLines{scene}.find(camera, settingsOf(options)).lines;
}

template <class Want>
std::vector<Line> thoseOf(const std::vector<Line>& lines, Want want) {
    std::vector<Line> some;
    std::ranges::copy_if(lines, std::back_inserter(some), want);
    return some;
}

inline std::vector<Line> thoseOf(const std::vector<Line>& lines, LineType type) {
    return thoseOf(lines, [&](const Line& line) { return line.type == type; });
}

/// Calls visit(p, q) for each straight piece.
template <class Visit>
void forEachPiece(const Line& line, Visit visit) {
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) visit(line.points[i], line.points[i + 1]);
    if (line.closed) visit(line.points.back(), line.points.front());
}

/// Pixels.
inline double length(const Line& line) {
    double sum = 0.0;
    forEachPiece(line, [&](const LinePoint& p, const LinePoint& q) { sum += glm::distance(p.pixel, q.pixel); });
    return sum;
}

inline double length(const std::vector<Line>& lines) {
    double sum = 0.0;
    for (const Line& line : lines) sum += length(line);
    return sum;
}

/// Around the y axis; exact normals.
inline Mesh torus(double ring, double tube, std::uint32_t around, std::uint32_t across) {
    Mesh mesh;
    mesh.name = "torus";
    for (std::uint32_t i = 0; i < around; ++i) {
        const double u = 2.0 * std::numbers::pi * i / around;
        for (std::uint32_t j = 0; j < across; ++j) {
            const double v = 2.0 * std::numbers::pi * j / across;
            const glm::dvec3 out{std::cos(u), 0, std::sin(u)};
            const glm::dvec3 normal = std::cos(v) * out + glm::dvec3{0, std::sin(v), 0};
            mesh.positions.emplace_back(ring * out + tube * normal);
            mesh.normals.emplace_back(normal);
            const std::uint32_t a = i * across + j;
            const std::uint32_t b = (i + 1) % around * across + j;
            const std::uint32_t c = i * across + (j + 1) % across;
            const std::uint32_t d = (i + 1) % around * across + (j + 1) % across;
            mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
        }
    }
    return mesh;
}

/// In n x n cells about the origin in the plane y = 0, its front up; without normals.
inline Mesh sheet(double side, std::uint32_t n = 1) {
    Mesh mesh;
    mesh.name = "sheet";
    for (std::uint32_t i = 0; i <= n; ++i)
        for (std::uint32_t j = 0; j <= n; ++j)
            mesh.positions.emplace_back(side * (double(i) / n - 0.5), 0.0, side * (double(j) / n - 0.5));
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t j = 0; j < n; ++j) {
            const std::uint32_t a = i * (n + 1) + j;
            const std::uint32_t b = a + n + 1;
            mesh.indices.insert(mesh.indices.end(), {a, a + 1, b, b, a + 1, b + 1});
        }
    }
    return mesh;
}

}  // namespace inkedge::lines::views
