#include "mesh/polygon_triangles.h"

#include <algorithm>
#include <utility>

#include "mesh/tessellator.h"
#include "modules/failure.h"

namespace inkedge::mesh {
namespace {

double signedDoubleArea(const Polygon& polygon) {
    double area = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i];
        const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
        area += a.x * b.y - a.y * b.x;
    }
    return area;
}

const Tessellator& tessellator() { return modules::functionsOf<tessellatorModule>(Error::Kind::Input); }

}  // namespace

std::vector<PolygonTriangle> convexTriangles(const Polygon& polygon) {
    std::vector<PolygonTriangle> triangles;
    const bool anticlockwise = signedDoubleArea(polygon) >= 0.0;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        PolygonTriangle t{polygon[0], polygon[i - 1], polygon[i]};
        if (!anticlockwise) std::swap(t[1], t[2]);
        triangles.push_back(t);
    }
    return triangles;
}

std::vector<Polygon> untangled(std::span<const Polygon> loops) {
    return modules::expectNoFailure(tessellator().border(loops), Error::Kind::Input).loops;
}

std::vector<PolygonTriangle> trianglesWithin(const Polygon& polygon, std::span<const Polygon> area) {
    Polygon anticlockwise = polygon;
    if (signedDoubleArea(polygon) < 0.0) std::ranges::reverse(anticlockwise);
    const Tessellation found = modules::expectNoFailure(tessellator().overlap(area, anticlockwise), Error::Kind::Input);
    std::vector<PolygonTriangle> triangles;
    for (const Polygon& run : found.loops)
        for (std::size_t i = 2; i < run.size(); i += 3) triangles.push_back({run[i - 2], run[i - 1], run[i]});
    return triangles;
}

}  // namespace inkedge::mesh
