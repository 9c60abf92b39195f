#include "ink/stroke_widths.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge::ink {
namespace {

constexpr double narrowest = 0.5;  // share of the pen's width where a line is furthest or most bent
constexpr double widest = 1.5;     // share of the pen's width where a line is nearest or straight
constexpr double bendStep = 3.0;   // pixels between points that follow a line's bends
constexpr int bendReach = 3;       // steps to either side over which a bend is measured
constexpr double halfBend = 15.0;  // pixels: the radius at which a line is half-way between narrowest and widest

double turn(glm::dvec2 in, glm::dvec2 out) {
    return std::abs(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)));
}

StrokePoint between(const StrokePoint& a, const StrokePoint& b, double share) {
    return {glm::mix(a.pixel, b.pixel, share), glm::mix(a.width, b.width, share)};
}

// The points of a line, with more between them so that no two are further apart than step.
std::vector<StrokePoint> refined(const std::vector<StrokePoint>& points, double step) {
    std::vector<StrokePoint> all{points.front()};
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double parts = std::max(1.0, std::ceil(glm::distance(points[i - 1].pixel, points[i].pixel) / step));
        for (double k = 1.0; k <= parts; ++k) all.push_back(between(points[i - 1], points[i], k / parts));
    }
    return all;
}

// Sets widths by curvature: straighter parts are wider.
void setByBends(std::vector<StrokePoint>& points, bool closed) {
    points = refined(points, bendStep);
    const int last = static_cast<int>(points.size()) - 1;
    const auto at = [&](int i) {
        if (closed && last > 0) i = (i % last + last) % last;
        return points[static_cast<std::size_t>(std::clamp(i, 0, last))].pixel;
    };
    for (int i = 0; i <= last; ++i) {
        const glm::dvec2 in = at(i) - at(i - bendReach);
        const glm::dvec2 out = at(i + bendReach) - at(i);
        const double way = 0.5 * (glm::length(in) + glm::length(out));
        const bool atEnd = in == glm::dvec2{0.0} || out == glm::dvec2{0.0};
        const double curvature = atEnd || way == 0.0 ? 0.0 : turn(in, out) / way;
        points[static_cast<std::size_t>(i)].width = glm::mix(narrowest, widest, 1.0 / (1.0 + halfBend * curvature));
    }
}

void setByStrength(const Line& line, std::vector<StrokePoint>& points) {
    if (!formLineTypes.contains(line.type)) return;
    for (std::size_t i = 0; i < points.size(); ++i)
        points[i].width = std::clamp(line.points[i % line.points.size()].strength, 0.0, 1.0);
}

double lengthOf(const std::vector<StrokePoint>& points) {
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) length += glm::distance(points[i - 1].pixel, points[i].pixel);
    return length;
}

// Tapers free ends to nothing over a length. A line with two free ends that is shorter than twice that length has its
// whole width nowhere.
std::vector<StrokePoint> tapered(const std::vector<StrokePoint>& points, double taper, bool begins, bool ends) {
    const double length = lengthOf(points);
    if (begins != ends && length > 0.0) taper = std::min(taper, length);  // the other end keeps its width
    const double half = begins && ends ? 0.5 * length : length;
    const double turnPoints[]{begins ? std::min(taper, half) : 0.0,
                              ends ? std::max(length - taper, length - half) : length};
    const auto share = [&](double way) {
        const double fromEnd = std::min(begins ? way : taper, ends ? length - way : taper);
        return std::clamp(fromEnd / taper, 0.0, 1.0);
    };
    std::vector<StrokePoint> all{{points.front().pixel, points.front().width * share(0.0)}};
    double begin = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double end = begin + glm::distance(points[i - 1].pixel, points[i].pixel);
        double before = begin;
        for (const double way : turnPoints) {
            if (way <= before || way >= end) continue;
            before = way;
            all.push_back(between(points[i - 1], points[i], (way - begin) / (end - begin)));
            all.back().width *= share(way);
        }
        all.push_back({points[i].pixel, points[i].width * share(end)});
        begin = end;
    }
    return all;
}

}  // namespace

StrokeWidths::StrokeWidths(const Lines& lines, const PictureSettings& picture, const LineSettings& settings)
    : camera_{lines.camera}, kind_{settings.strokeWidth}, taper_{settings.strokeTaper} {
    if (taper_ > 0.0) freeEnds_.emplace(lines, picture, settings);
    if (kind_ != StrokeWidth::Depth) return;
    furthest_ = std::numeric_limits<double>::infinity();
    nearest_ = -furthest_;
    for (const Line& line : lines.lines) {
        for (const LinePoint& p : line.points) {
            const double near = inverseDepth(p);
            if (!std::isfinite(near)) continue;
            furthest_ = std::min(furthest_, near);
            nearest_ = std::max(nearest_, near);
        }
    }
}

bool StrokeWidths::vary() const noexcept { return kind_ != StrokeWidth::Constant || taper_ > 0.0; }

double StrokeWidths::inverseDepth(const LinePoint& p) const {
    const double z = (camera_.view * glm::dvec4{p.position, 1.0}).z;
    return camera_.orthographic() ? z : -1.0 / z;
}

void StrokeWidths::setByDepth(const Line& line, std::vector<StrokePoint>& points) const {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double near = inverseDepth(line.points[i % line.points.size()]);
        const double share = nearest_ > furthest_ ? (near - furthest_) / (nearest_ - furthest_) : 0.5;
        points[i].width = std::isfinite(share) ? glm::mix(narrowest, widest, std::clamp(share, 0.0, 1.0)) : 1.0;
    }
}

std::vector<StrokePoint> StrokeWidths::along(const Line& line, const Line& whole) const {
    std::vector<StrokePoint> points;
    for (const LinePoint& p : line.points) points.push_back({p.pixel});
    if (points.empty()) return points;
    if (line.closed) points.push_back(points.front());
    if (kind_ == StrokeWidth::Depth) setByDepth(line, points);
    if (kind_ == StrokeWidth::Curvature) setByBends(points, line.closed);
    if (kind_ == StrokeWidth::Strength) setByStrength(line, points);
    if (!freeEnds_ || whole.closed) return points;
    const LinePoint& first = whole.points.front();
    const LinePoint& last = whole.points.back();
    const bool begins = line.points.front().pixel == first.pixel && freeEnds_->has(first);
    const bool ends = line.points.back().pixel == last.pixel && freeEnds_->has(last);
    return begins || ends ? tapered(points, taper_, begins, ends) : points;
}

}  // namespace inkedge::ink
