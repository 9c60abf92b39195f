#include "trace/crossings.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "raster/pair_mark.h"

namespace inkedge::trace {
namespace {

constexpr double minBend = 0.05;  // pixel footprints over a step: planes that bend by less do not say where they meet

}  // namespace

CrossingTracer::CrossingTracer(const LineBuffers& buffers, const ScreenTriangles& triangles, const Camera& camera)
    : buffers_{buffers},
      triangles_{triangles},
      orthographic_{camera.orthographic()},
      focalLengths_{camera.focalLengths(buffers.tile.whole)},
      centre_{camera.centre(buffers.tile.whole)},
      creaseCosine_{std::cos(glm::radians(triangles.creaseAngle()))},
      columns_{aroundKept(buffers.tile)},
      types_{buffers.marks.size(), 1} {}

void CrossingTracer::traceRow(int y, CrossingRow& crossings) {
    crossings.clear();
    forEachMarked(buffers_.marks, y, columns_.x, columns_.x + columns_.size.width, [&](int x) {
        const unsigned marks = buffers_.marks(x, y);
        const auto column = static_cast<std::size_t>(x);
        if ((marks & rightMarks) != 0)
            cross({x, y}, {x + 1, y}, marks & rightMarks, crossings.right[column], crossings.rightStrips[column]);
        if ((marks >> 4U) != 0)
            cross({x, y}, {x, y + 1}, marks >> 4U, crossings.down[column], crossings.downStrips[column]);
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

ScreenTriangles::BothWalks CrossingTracer::walk(Sample from, Sample to) const {
    return triangles_.walkBoth(triangle(from), centre(from), centre(to));
}

// Where coplanar layers overlap a pixel holds the sum of their patches' numbers. If one side has one layer more, the
// difference is the number of that layer.
std::optional<ScreenTriangles::LayerBorder> CrossingTracer::layerBorder(Sample from, Sample to) const {
    constexpr float maxNumber = 0x1p24F;  // other patches' numbers differ by more: see PlaneBuffers
    const float difference = std::abs(buffers_.planes(from.x, from.y, 3) - buffers_.planes(to.x, to.y, 3));
    if (!(difference < maxNumber)) return {};
    return triangles_.layerBorder(static_cast<std::uint32_t>(difference), centre(from), centre(to));
}

// The plane of a sample's triangle. Planes that were drawn are rounded differently in each tile; this one is the same
// in all tiles.
ScreenTriangles::Plane CrossingTracer::plane(Sample s) const { return triangles_.plane(triangle(s), centre(s)); }

// The normal of a sample's plane up to a positive factor, turned to the eye, as in shaders/shared/planes.glsl.
glm::dvec3 CrossingTracer::normal(Sample s) const {
    const ScreenTriangles::Plane seen = plane(s);
    const glm::dvec2 slope{seen.dx, seen.dy};
    return {slope * focalLengths_, orthographic_ ? 1.0 : seen.w - glm::dot(slope, centre(s) - centre_)};
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
    const double focal = focalLengths_[p.x == q.x ? 1 : 0];
    const double footprints = orthographic_ ? focal : focal / std::max(atP.w, atQ.w);
    const double bend = std::abs(rp + rq) * footprints;
    if (rp * rq < 0.0 || !(bend > minBend) || !std::isfinite(bend)) return {};  // faces seen edge-on have no plane
    return rq / (rp + rq);
}

// Where a line crosses the step from near to far, 0 to 1. If the nearer surface goes on to the far sample, where it is
// not seen any more, it ends there, within the grid that vertices snap to.
double CrossingTracer::positionAlong(const Step& step) const {
    const auto& [near, far, marks, way, whole, farWay, back, bends, strip] = step;
    if (step.jumps()) {  // a crease that is nearer than the surface's end has more of the surface behind it
        if (whole.exit && whole.exit->end != End::Crease) return whole.exit->t;
        return way.exit ? way.exit->t : way.arrivedAt ? 1.0 : 0.5;
    }
    const bool forward = near.x <= far.x && near.y <= far.y;
    if (const std::optional<double> meet = forward ? planesMeet(near, far) : planesMeet(far, near)) {
        const double t = forward ? *meet : 1.0 - *meet;
        if (bends) return t;
        // A surface that ends before its plane meets the other one's lies in front of it, by little.
        const double begin = farWay.exit ? 1.0 - farWay.exit->t : 0.0;
        const double from = std::max(t, begin);
        return way.exit ? std::min(from, strip ? whole.exit->t : way.exit->t) : from;
    }
    if (way.exit) return strip ? whole.exit->t : way.exit->t;
    if (farWay.exit) return 1.0 - farWay.exit->t;
    const auto border = layerBorder(near, far);
    return border ? border->t : 0.5;
}

void CrossingTracer::cross(Sample p, Sample q, unsigned marks, StepCrossing& line, StepCrossing& strip) {
    const bool swap = isBackground(p) || (!isBackground(q) && isNearer(q, p));
    Step step{swap ? q : p, swap ? p : q, marks, {}, {}, {}, {}, false, false};
    const auto& [near, far] = std::pair{step.near, step.far};
    const auto [patch, surface] = walk(near, far);
    step.way = patch;
    if ((marks & ~(raster::PairMark::bend | raster::PairMark::jump)) == 0 && goesOnSmoothly(step)) return;
    const bool atCrease = step.way.exit && step.way.exit->end == End::Crease;
    // A slight bend is marked for creases that end within their patch; it is none by itself.
    if (marks == raster::PairMark::bend && !atCrease && !bendsByCreaseAngle(near, far)) return;
    step.whole = atCrease ? surface : patch;
    if (!step.jumps()) {
        const auto [farPatch, farSurface] = walk(far, near);
        step.farWay = farPatch;
        step.back = farSurface;
        if (isSeam(step)) return;
        step.bends = isBend(step);
    }
    step.passesStrip = passesStrip(step);
    line = crossing(step);
    if (step.passesStrip) strip = creaseOfStrip(step);
    if (step.passesStrip || !step.bends || line.types != LineType::Crease) return;
    line.width = stripWidth(step, line.position);
    if (line.width < 1.0F) std::swap(line, strip);
}

StepCrossing CrossingTracer::crossing(const Step& step) {
    const auto& [near, far] = std::pair{step.near, step.far};
    const LineTypes types = classify(step);
    types_(near.x, near.y) |= static_cast<std::uint16_t>(types.bits());
    const glm::dvec2 from = centre(near);
    const glm::dvec2 position = from + positionAlong(step) * (centre(far) - from);
    const Sample its = farOwns(step) ? far : near;
    return {glm::vec2{position}, types, inverseDepthAt(its, position - centre(its)), owner(step)};
}

bool CrossingTracer::passesStrip(const Step& step) const {
    constexpr double minWidth = 1.0 / 128;  // samples: vertices snap to a grid of 1/256
    const auto& [way, whole] = std::pair{step.way.exit, step.whole.exit};
    if (step.bends || !way || !whole || way->end != End::Crease || whole->end == End::Crease) return false;
    if (whole->t - way->t < minWidth) return false;
    return step.jumps() || !touches(step.near, step.far, step.way.last, way->t);
}

StepCrossing CrossingTracer::creaseOfStrip(const Step& step) const {
    const double t = step.way.exit->t;
    const glm::dvec2 offset = t * (centre(step.far) - centre(step.near));
    return {glm::vec2{centre(step.near) + offset}, LineType::Crease, inverseDepthAt(step.near, offset),
            triangle(step.near), static_cast<float>(step.whole.exit->t - t)};
}

// How far from a crease its surface ends on one of the two sides, samples along the step; 1: it does not, or further.
float CrossingTracer::stripWidth(const Step& step, glm::dvec2 crease) const {
    const auto beyond = [&](Sample from, Sample at) { return glm::distance(crease, centre(at)) + endBeyond(from, at); };
    return static_cast<float>(std::min({1.0, beyond(step.near, step.far), beyond(step.far, step.near)}));
}

// Where the surface seen at a sample ends on the step that goes on from another one: samples; 1: it does not.
double CrossingTracer::endBeyond(Sample from, Sample at) const {
    const Sample next{2 * at.x - from.x, 2 * at.y - from.y};
    const Size size = buffers_.marks.size();
    if (next.x < 0 || next.y < 0 || next.x >= size.width || next.y >= size.height) return 1.0;
    const unsigned marks = buffers_.marks(std::min(at.x, next.x), std::min(at.y, next.y));
    if ((at.x != next.x ? marks & rightMarks : marks >> 4U) == 0) return 1.0;
    const auto exit = triangles_.walk(triangle(at), centre(at), centre(next), ScreenTriangles::Over::Surface).exit;
    return exit && exit->end != End::Crease ? exit->t : 1.0;
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
bool CrossingTracer::goesOnSmoothly(const Step& step) const {
    if (step.way.exit) return false;
    const scene::SceneFace seen = triangle(step.far);
    return !step.way.arrivedAt || triangles_.touch({seen.instance, *step.way.arrivedAt}, seen);
}

// Whether a walk from a sample to another ends on the patch that is seen there.
bool CrossingTracer::arrives(const Walk& walk, Sample from, Sample to) const {
    return walk.arrivedAt &&
           triangles_.patchOf({triangle(from).instance, *walk.arrivedAt}) == triangles_.patchOf(triangle(to));
}

// Whether the surfaces of two samples meet in a crease: one of them goes on to the other sample, or both end at one
// edge, of the mesh or of two meshes, and bend there.
bool CrossingTracer::isBend(const Step& step) const {
    constexpr double sameEdge = 0.1;  // samples: well over the width of seams
    if (arrives(step.whole, step.near, step.far) || arrives(step.back, step.far, step.near)) return true;
    if ((step.marks & raster::PairMark::bend) == 0) return false;
    const auto walkBeyond = [&](Sample from, Sample to) {  // the edge may pass through a sample's centre
        const glm::dvec2 goal = glm::mix(centre(from), centre(to), 1.0 + sameEdge);
        return triangles_.walk(triangle(from), centre(from), goal, ScreenTriangles::Over::Surface).exit;
    };
    const std::optional<Exit> exit = walkBeyond(step.near, step.far);
    const std::optional<Exit> other = walkBeyond(step.far, step.near);
    if (!exit || !other || exit->end != other->end || exit->end == End::Fold) return false;
    return std::abs((exit->t + other->t) * (1.0 + sameEdge) - 1.0) < sameEdge;
}

// Whether both samples' meshes end at one seam, across which one surface goes on.
bool CrossingTracer::isSeam(const Step& step) const {
    const auto& [one, other] = std::pair{step.way.exit, step.farWay.exit};
    if (!one || !other || one->end != End::Border || other->end != End::Border) return false;
    const double focal = focalLengths_[step.near.x == step.far.x ? 1 : 0];
    const double perUnit = orthographic_ ? focal : focal * plane(step.near).w;
    if (std::abs(one->t + other->t - 1.0) > triangles_.seamWidth() * perUnit) return false;
    const auto goOn = triangles_.goOnAcrossSeam(triangle(step.near).instance, one->halfEdge,
                                                triangle(step.far).instance, other->halfEdge);
    return goOn ? *goOn : !bendsByCreaseAngle(step.near, step.far);  // by a corner that touches only
}

// How far a face lies in front of another one, across the other one's plane, in samples.
double CrossingTracer::gap(scene::SceneFace front, scene::SceneFace behind, glm::dvec2 at) const {
    const Plane nearer = triangles_.plane(front, at);
    const Plane plane = triangles_.plane(behind, at);
    const glm::dvec2 slope{plane.dx, plane.dy};
    const glm::dvec3 normal{slope * focalLengths_, orthographic_ ? 1.0 : plane.w - glm::dot(slope, at - centre_)};
    return (nearer.w - plane.w) * focalLengths_.y / glm::length(normal);
}

// Whether a face that the surface of one sample ends on touches the surface of another one, at a share of the way.
bool CrossingTracer::touches(Sample from, Sample to, std::uint32_t face, double t) const {
    constexpr double touching = 0.1;  // samples
    const glm::dvec2 at = glm::mix(centre(from), centre(to), t);
    return !(gap({triangle(from).instance, face}, triangle(to), at) > touching);
}

// What a line is between two surfaces that are not seen to jump. They touch, run into each other, or one ends in front
// of the other, less than a sample away.
LineTypes CrossingTracer::meeting(const Step& step) const {
    const auto& [near, far, marks, way, whole, farWay, back, bends, strip] = step;
    if (!way.exit && arrives(way, near, far)) return LineType::Intersection;  // with a layer in the plane of both
    if (bends) return LineType::Crease;
    if (way.exit && way.exit->end == End::Fold) return LineType::Occlusion;
    const bool farEnds = !way.exit && farWay.exit;
    if (!way.exit && !farEnds) return LineType::Intersection;
    const Walk& patch = farEnds ? farWay : way;
    const Walk& surface = farEnds ? back : whole;  // goes on beyond a crease
    const Sample ending = farEnds ? far : near;
    const Sample other = farEnds ? near : far;
    if (touches(ending, other, patch.last, patch.exit->t)) return LineType::Intersection;
    const bool beyondCrease = patch.exit->end == End::Crease && !strip;
    if (!surface.exit || (beyondCrease && touches(ending, other, surface.last, surface.exit->t)))
        return LineType::Crease | LineType::Intersection;
    const bool atBorder = surface.exit->end == End::Border;
    return atBorder ? LineType::Occlusion | LineType::Boundary : LineTypes{LineType::Occlusion};
}

LineTypes CrossingTracer::classify(const Step& step) const {
    const bool atBorder = step.whole.exit && step.whole.exit->end == End::Border;
    const LineTypes boundary = atBorder ? LineTypes{LineType::Boundary} : LineTypes{};
    if ((step.marks & raster::PairMark::background) != 0) return LineType::Outline | boundary;
    const bool otherObject = triangle(step.near).instance != triangle(step.far).instance;
    const LineTypes object = otherObject ? LineTypes{LineType::Object} : LineTypes{};
    // As where a sample sees the strip.
    if (step.passesStrip && touches(step.near, step.far, step.whole.last, step.whole.exit->t))
        return object | LineType::Intersection;
    return object | (step.jumps() ? LineType::Occlusion | boundary : meeting(step));
}

// Where the surfaces of two nodes meet either may be the nearer one, from sample to sample. The line belongs to the one
// that ends there or, if both do, to the first node.
bool CrossingTracer::farOwns(const Step& step) const {
    if (step.jumps()) return false;
    const std::uint32_t nodes[2]{triangle(step.near).instance, triangle(step.far).instance};
    if (nodes[0] == nodes[1]) return false;
    const bool farEnds = step.farWay.exit.has_value();
    return step.way.exit.has_value() == farEnds ? nodes[1] < nodes[0] : farEnds;
}

scene::SceneFace CrossingTracer::owner(const Step& step) const {
    const scene::SceneFace seen = triangle(farOwns(step) ? step.far : step.near);
    if (step.jumps() || step.way.exit) return seen;
    const auto border = layerBorder(step.near, step.far);
    return border ? border->face : seen;
}

}  // namespace inkedge::trace
