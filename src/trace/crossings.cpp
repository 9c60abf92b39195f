#include "trace/crossings.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "raster/pair_mark.h"

namespace inkedge::trace {
namespace {

constexpr double minBend = 0.05;  // pixel footprints over a step: planes that bend by less do not say where they meet
constexpr unsigned rightMarks = 0x0F;

}  // namespace

CrossingTracer::CrossingTracer(const LineBuffers& buffers, const ScreenTriangles& triangles, const Camera& camera)
    : buffers_{buffers},
      triangles_{triangles},
      orthographic_{camera.orthographic()},
      focalLength_{camera.focalLength(buffers.tile.whole)},
      creaseCosine_{std::cos(glm::radians(triangles.creaseAngle()))},
      columns_{aroundKept(buffers.tile)},
      types_{buffers.marks.size(), 1} {}

void CrossingTracer::traceRow(int y, CrossingRow& crossings) {
    crossings.clear();
    forEachMarked(buffers_.marks, y, columns_.x, columns_.x + columns_.size.width, [&](int x) {
        const unsigned marks = buffers_.marks(x, y);
        const auto column = static_cast<std::size_t>(x);
        if ((marks & rightMarks) != 0) crossings.right[column] = crossing({x, y}, {x + 1, y}, marks & rightMarks);
        if ((marks >> 4U) != 0) crossings.down[column] = crossing({x, y}, {x, y + 1}, marks >> 4U);
        crossings.columns.push_back(x);
    });
}

bool CrossingTracer::isBackground(Sample s) const { return buffers_.triangles(s.x, s.y) == 0; }

scene::SceneFace CrossingTracer::triangle(Sample s) const {
    return triangles_.locate(buffers_.triangles(s.x, s.y) - 1);
}

glm::dvec2 CrossingTracer::centre(Sample s) const {
    const raster::Rectangle& drawn = buffers_.tile.drawn;
    return {s.x + drawn.x + 0.5, s.y + drawn.y + 0.5};
}

CrossingTracer::Walk CrossingTracer::walk(Sample from, Sample to) const {
    return triangles_.walk(triangle(from), centre(from), centre(to));
}

// Where coplanar layers overlap a pixel holds the sum of their patches' numbers. If one side has one layer more, the
// difference is the number of that layer.
std::optional<double> CrossingTracer::layerBorder(Sample from, Sample to) const {
    const float difference = buffers_.planes(from.x, from.y, 3) - buffers_.planes(to.x, to.y, 3);
    return triangles_.layerBorder(static_cast<std::uint32_t>(std::abs(difference)), centre(from), centre(to));
}

// The plane of a sample's triangle. Planes that were drawn are rounded differently in each tile; this one is the same
// in all tiles.
ScreenTriangles::Plane CrossingTracer::plane(Sample s) const { return triangles_.plane(triangle(s), centre(s)); }

// The normal of a sample's plane up to a positive factor, turned to the eye, as in shaders/shared/planes.glsl.
glm::dvec3 CrossingTracer::normal(Sample s) const {
    const ScreenTriangles::Plane seen = plane(s);
    const raster::Rectangle& drawn = buffers_.tile.drawn;
    const Size whole = buffers_.tile.whole;
    const glm::dvec2 at{s.x + drawn.x + 0.5 - 0.5 * whole.width, s.y + drawn.y + 0.5 - 0.5 * whole.height};
    const double towards = orthographic_ ? 1.0 : seen.w - seen.dx * at.x - seen.dy * at.y;
    return {seen.dx * focalLength_, seen.dy * focalLength_, towards};
}

bool CrossingTracer::bendsByCreaseAngle(Sample p, Sample q) const {
    const glm::dvec3 np = normal(p);
    const glm::dvec3 nq = normal(q);
    return glm::dot(np, nq) < creaseCosine_ * std::sqrt(glm::dot(np, np) * glm::dot(nq, nq));
}

bool CrossingTracer::isNearer(Sample q, Sample p) const {
    constexpr double rounding = 1e-5;  // of drawn planes: a few steps of a float
    const double wp = static_cast<double>(buffers_.planes(p.x, p.y));
    const double wq = static_cast<double>(buffers_.planes(q.x, q.y));
    if (std::abs(wp - wq) > rounding * std::max(std::abs(wp), std::abs(wq))) return wq > wp;
    constexpr double equal = 1e-9;  // faces of equal depth count as equal, however numbers are rounded
    const double atP = plane(p).w;
    const double atQ = plane(q).w;
    return atQ - atP > equal * std::max(std::abs(atP), std::abs(atQ));
}

// Where the planes of p and q meet on the step from p to q; none if they do not, or bend too little to say.
std::optional<double> CrossingTracer::planesMeet(Sample p, Sample q) const {
    const ScreenTriangles::Plane atP = plane(p);
    const ScreenTriangles::Plane atQ = plane(q);
    const double rp = atQ.w - (atP.w + (p.x == q.x ? atP.dy : atP.dx));
    const double rq = atP.w - (atQ.w - (p.x == q.x ? atQ.dy : atQ.dx));
    const double footprints = orthographic_ ? focalLength_ : focalLength_ / std::max(atP.w, atQ.w);
    const double bend = std::abs(rp + rq) * footprints;
    if (rp * rq < 0.0 || !(bend > minBend) || !std::isfinite(bend)) return {};  // faces seen edge-on have no plane
    return rq / (rp + rq);
}

// Where a line crosses the step from near to far, 0 to 1. If the nearer surface goes on to the far sample, where it is
// not seen any more, it ends there, within the grid that vertices snap to.
double CrossingTracer::positionAlong(Sample near, Sample far, unsigned marks, const Walk& way) const {
    const bool jumps = (marks & (raster::PairMark::background | raster::PairMark::jump)) != 0;
    const double otherwise = way.exit ? way.exit->t : jumps && way.arrivedAt ? 1.0 : 0.5;
    if (jumps) return otherwise;
    const bool forward = near.x <= far.x && near.y <= far.y;
    if (const std::optional<double> meet = forward ? planesMeet(near, far) : planesMeet(far, near))
        return forward ? *meet : 1.0 - *meet;
    if (way.exit) return otherwise;
    if (const Walk back = walk(far, near); back.exit) return 1.0 - back.exit->t;
    return layerBorder(near, far).value_or(otherwise);
}

StepCrossing CrossingTracer::crossing(Sample p, Sample q, unsigned marks) {
    const bool swap = isBackground(p) || (!isBackground(q) && isNearer(q, p));
    const Sample near = swap ? q : p;
    const Sample far = swap ? p : q;
    const Walk way = walk(near, far);
    if ((marks & ~(raster::PairMark::bend | raster::PairMark::jump)) == 0 && goesOnSmoothly(way, far)) return {};
    // A slight bend is marked for creases that end within their patch; it is none by itself.
    const bool atCrease = way.exit && way.exit->end == End::Crease;
    if (marks == raster::PairMark::bend && !atCrease && !bendsByCreaseAngle(near, far)) return {};

    const LineTypes types = classify(near, far, marks, way.exit);
    types_(near.x, near.y) |= static_cast<std::uint16_t>(types.bits());
    const glm::dvec2 from = centre(near);
    const glm::dvec2 offset = positionAlong(near, far, marks, way) * (centre(far) - from);
    return {glm::vec2{from + offset}, types, inverseDepthAt(near, offset), triangle(near)};
}

// The inverse depth of the surface that a sample sees, extended to the line. Beyond the sample itself faces seen
// edge-on say little of it.
float CrossingTracer::inverseDepthAt(Sample s, glm::dvec2 offset) const {
    constexpr double maxChange = 0.1;
    const ScreenTriangles::Plane seen = plane(s);
    const double step = seen.dx * offset.x + seen.dy * offset.y;
    return static_cast<float>(std::abs(step) <= maxChange * std::abs(seen.w) ? seen.w + step : seen.w);
}

// Whether one patch goes on from a sample to another, so that there is no line. Its faces may bend by more than the
// crease angle in several smooth steps, or fall off by more than their planes say where narrow faces lie between them.
// If the walk ends on another triangle than the one seen there, the patch runs into itself.
bool CrossingTracer::goesOnSmoothly(const Walk& way, Sample far) const {
    if (way.exit) return false;
    const scene::SceneFace seen = triangle(far);
    return !way.arrivedAt || triangles_.touch({seen.instance, *way.arrivedAt}, seen);
}

LineTypes CrossingTracer::classify(Sample near, Sample far, unsigned marks,
                                   const std::optional<ScreenTriangles::Exit>& exit) const {
    const bool atBorder = exit && exit->end == End::Border;
    const LineTypes boundary = atBorder ? LineTypes{LineType::Boundary} : LineTypes{};
    if ((marks & raster::PairMark::background) != 0) return LineType::Outline | boundary;
    const bool otherObject = triangle(near).instance != triangle(far).instance;
    const LineTypes object = otherObject ? LineTypes{LineType::Object} : LineTypes{};
    if ((marks & raster::PairMark::jump) != 0) return LineType::Occlusion | boundary | object;
    if (otherObject) return LineType::Intersection | object;
    if (exit && exit->end == End::Fold) return LineType::Occlusion;
    return exit ? LineType::Crease : LineType::Intersection;
}

}  // namespace inkedge::trace
