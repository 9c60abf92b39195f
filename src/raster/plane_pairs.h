#pragma once

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "raster/pair_mark.h"

namespace inkedge::raster {

/// The plane and the patch that a sample sees, as reference::detectLines() takes them.
struct SeenPlane {
    double w;
    glm::dvec2 slope;       ///< of w, per sample
    double patch;           ///< 0: background
    glm::dvec2 fromCentre;  ///< the sample, from the picture's centre
};

/// How samples are seen, as reference::detectLines() takes it.
struct PlaneView {
    glm::dvec2 focalLengths;
    bool orthographic;
    double creaseCosine;  ///< of the crease angle
};

/// The face normal, with any positive length.
[[nodiscard]] inline glm::dvec3 normalOf(const SeenPlane& plane, const PlaneView& view) {
    const double along = view.orthographic ? 1.0 : plane.w - glm::dot(plane.slope, plane.fromCentre);
    return {plane.slope * view.focalLengths, along};
}

/// The smallest jump within one patch, as a share of the one between patches. There the mesh has the last word: only
/// where the patch does not go on from the one sample to the other is it a jump. What is smaller is rounding.
inline constexpr double minJumpWithinPatch = 0.02;

/// The definition of reference::detectLines() for one pair of samples.
/// @param axis  along which q follows p: 0 to the right, 1 below
[[nodiscard]] inline unsigned pairMarks(const SeenPlane& p, const SeenPlane& q, int axis, const PlaneView& view) {
    if (p.patch == 0.0 || q.patch == 0.0) return p.patch == q.patch ? 0 : PairMark::background;
    unsigned marks = p.patch == q.patch ? 0 : PairMark::patch;

    const glm::dvec3 np = normalOf(p, view);
    const glm::dvec3 nq = normalOf(q, view);
    if (glm::dot(np, nq) < view.creaseCosine * glm::length(np) * glm::length(nq)) marks |= PairMark::bend;

    const double gp = p.slope[axis];
    const double gq = q.slope[axis];
    const double rp = q.w - (p.w + gp);
    const double rq = p.w - (q.w - gq);
    const double k = view.focalLengths[axis] / (view.orthographic ? 1.0 : std::max(p.w, q.w));
    const double slope = std::min(std::abs(gp), std::abs(gq)) * k;
    const double limit = p.patch == q.patch ? minJumpWithinPatch : 1.0;
    if (rp * rq < 0.0 && std::min(std::abs(rp), std::abs(rq)) * k > limit * (1.0 + slope)) marks |= PairMark::jump;
    return marks;
}

}  // namespace inkedge::raster
