#include "curves/fit_beziers.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "curves/simplify.h"

namespace inkedge::curves {
namespace {

using glm::dvec2;

constexpr double sharpTurn = 1.0;        // radians: this or more is a corner at any scale
constexpr double slightTurn = 0.15;      // radians: this or less is no corner at any scale
constexpr int improvements = 4;          // of the parameters, by Newton's method
constexpr double worthImproving = 16.0;  // times the tolerance, squared distances
constexpr double sampleStep = 1.0;       // pixels between samples of a line's edges

dvec2 unitOr(dvec2 v, dvec2 otherwise) {
    const double length = glm::length(v);
    return length > 1e-12 ? v / length : otherwise;
}

double turn(dvec2 a, dvec2 b, dvec2 c) {
    const dvec2 in = b - a;
    const dvec2 out = c - b;
    return std::abs(std::atan2(in.x * out.y - in.y * out.x, glm::dot(in, out)));
}

// Chords that stay within d of a smooth curve are at most 8 d / turn long. Where they are longer there is a
// corner.
bool isCorner(dvec2 a, dvec2 b, dvec2 c, double tolerance) {
    const double angle = turn(a, b, c);
    if (angle > sharpTurn) return true;
    return angle > slightTurn && std::min(glm::distance(a, b), glm::distance(b, c)) * angle > 8.0 * tolerance;
}

// Fits curves to the samples of one stretch of a line without corners.
class StretchFitter {
public:
    StretchFitter(std::span<const dvec2> samples, double tolerance, std::vector<Bezier>& curves)
        : samples_{samples}, tolerance_{tolerance}, limit_{tolerance * tolerance}, curves_{curves} {}

    // Fits curves one after the other, each as long as it can be.
    // @param seam  the direction at both ends of a closed line without corners; 0 where the ends are corners
    void fit(dvec2 seam) {
        const std::size_t last = samples_.size() - 1;
        const bool smooth = seam != dvec2{0.0};
        const dvec2 atEnd = smooth ? -seam : directionFrom(last, 0);
        Stretch next{0, 0, smooth ? seam : directionFrom(0, last), {}};
        while (next.first < last) {
            const auto reaching = [&](std::size_t count) {
                const std::size_t to = std::min(next.first + count, last);
                return fitted({next.first, to, next.atFirst, to == last ? atEnd : -directionAcross(to)});
            };
            std::size_t good = 1;  // samples that the curve spans: one always fits
            std::optional<Bezier> best = reaching(good);
            std::size_t bad = 0;
            while (bad == 0 && next.first + good < last) {
                const std::size_t count = std::min(2 * good, last - next.first);
                const auto curve = reaching(count);
                (curve ? good : bad) = count;
                if (curve) best = curve;
            }
            while (bad > good + 1) {
                const std::size_t count = good + (bad - good) / 2;
                const auto curve = reaching(count);
                (curve ? good : bad) = count;
                if (curve) best = curve;
            }
            curves_.push_back(*best);
            next.first += good;
            next.atFirst = directionAcross(next.first);
        }
    }

private:
    struct Stretch {
        std::size_t first;
        std::size_t last;
        dvec2 atFirst;  // unit directions into the stretch
        dvec2 atLast;
    };

    // The length of line over which its direction is measured: longer than the line's noise.
    [[nodiscard]] double reach() const { return std::max(2.0 * sampleStep, 8.0 * tolerance_); }

    [[nodiscard]] std::size_t away(std::size_t from, std::size_t towards, double distance) const {
        const std::ptrdiff_t step = towards > from ? 1 : -1;
        double way = 0.0;
        while (from != towards && way < distance) {
            const auto next = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(from) + step);
            way += glm::distance(samples_[from], samples_[next]);
            from = next;
        }
        return from;
    }

    // The direction at an end, from the points of the line after half the reach and the whole: exact for a parabola.
    [[nodiscard]] dvec2 directionFrom(std::size_t end, std::size_t towards) const {
        const dvec2 far = samples_[away(end, towards, reach())] - samples_[end];
        const dvec2 near = samples_[away(end, towards, 0.5 * reach())] - samples_[end];
        const dvec2 chord = unitOr(far, {1.0, 0.0});
        return unitOr(2.0 * unitOr(near, chord) - chord, chord);
    }

    [[nodiscard]] dvec2 directionAcross(std::size_t at) const {
        const dvec2 ahead = samples_[away(at, samples_.size() - 1, reach())] - samples_[at];
        const dvec2 behind = samples_[at] - samples_[away(at, 0, reach())];
        return unitOr(unitOr(ahead, dvec2{0.0}) + unitOr(behind, dvec2{0.0}), unitOr(ahead, {1.0, 0.0}));
    }

    // The curve through a stretch; none if no curve with these directions is near enough.
    [[nodiscard]] std::optional<Bezier> fitted(const Stretch& stretch) const {
        const dvec2 a = samples_[stretch.first];
        const dvec2 b = samples_[stretch.last];
        if (stretch.last == stretch.first + 1) return Bezier{a, a + (b - a) / 3.0, b - (b - a) / 3.0, b};
        std::vector<double> at = byChords(stretch);
        Bezier curve = leastSquares(stretch, at);
        double error = worstError(stretch, at, curve);
        for (int i = 0; i < improvements && error > limit_ && error < worthImproving * limit_; ++i) {
            improve(stretch, curve, at);
            curve = leastSquares(stretch, at);
            error = worstError(stretch, at, curve);
        }
        if (error > limit_ || !staysNear(stretch, at, curve)) return std::nullopt;
        return curve;
    }

    [[nodiscard]] std::vector<double> byChords(const Stretch& stretch) const {
        std::vector<double> at{0.0};
        for (std::size_t i = stretch.first + 1; i <= stretch.last; ++i) {
            at.push_back(at.back() + glm::distance(samples_[i - 1], samples_[i]));
        }
        for (double& t : at) t /= at.back() > 0.0 ? at.back() : 1.0;
        at.back() = 1.0;
        return at;
    }

    // The curve whose control points lie along the end directions so that the sum of squared errors is smallest.
    [[nodiscard]] Bezier leastSquares(const Stretch& stretch, const std::vector<double>& at) const {
        const dvec2 a = samples_[stretch.first];
        const dvec2 b = samples_[stretch.last];
        double c00 = 0.0;
        double c01 = 0.0;
        double c11 = 0.0;
        double x0 = 0.0;
        double x1 = 0.0;
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double t = at[i];
            const double s = 1.0 - t;
            const dvec2 first = 3.0 * t * s * s * stretch.atFirst;
            const dvec2 second = 3.0 * t * t * s * stretch.atLast;
            const dvec2 rest =
                samples_[stretch.first + i] - a * (s * s * s + 3.0 * t * s * s) - b * (t * t * t + 3.0 * t * t * s);
            c00 += glm::dot(first, first);
            c01 += glm::dot(first, second);
            c11 += glm::dot(second, second);
            x0 += glm::dot(first, rest);
            x1 += glm::dot(second, rest);
        }
        const double chord = glm::distance(a, b);
        const double determinant = c00 * c11 - c01 * c01;
        double alongFirst = 0.0;
        double alongLast = 0.0;
        if (determinant > 1e-12 * c00 * c11) {
            alongFirst = (x0 * c11 - x1 * c01) / determinant;
            alongLast = (c00 * x1 - c01 * x0) / determinant;
        }
        // Out of range the solution is no curve of this shape; a third of the chord is the guess of Wu and Barsky.
        const double minLength = 1e-3 * chord;
        const double maxLength = 4.0 * std::max(chord, sampleStep);
        if (!(alongFirst > minLength && alongLast > minLength && alongFirst < maxLength && alongLast < maxLength)) {
            alongFirst = alongLast = chord / 3.0;
        }
        return {a, a + alongFirst * stretch.atFirst, b + alongLast * stretch.atLast, b};
    }

    // The largest distance from a sample to the curve; squared pixels.
    [[nodiscard]] double worstError(const Stretch& stretch, const std::vector<double>& at, const Bezier& curve) const {
        double worst = 0.0;
        for (std::size_t i = 1; i + 1 < at.size(); ++i) {
            const dvec2 off = pointAt(curve, at[i]) - samples_[stretch.first + i];
            worst = std::max(worst, glm::dot(off, off));
        }
        return worst;
    }

    // Whether the curve stays near the edge between each two samples.
    [[nodiscard]] bool staysNear(const Stretch& stretch, const std::vector<double>& at, const Bezier& curve) const {
        constexpr int parts = 4;
        for (std::size_t i = 1; i < at.size(); ++i) {
            const dvec2 a = samples_[stretch.first + i - 1];
            const dvec2 along = samples_[stretch.first + i] - a;
            const double length = glm::dot(along, along);
            for (int k = 1; k < parts; ++k) {
                const dvec2 p = pointAt(curve, glm::mix(at[i - 1], at[i], static_cast<double>(k) / parts)) - a;
                const double t = length > 0.0 ? std::clamp(glm::dot(p, along) / length, 0.0, 1.0) : 0.0;
                const dvec2 off = p - t * along;
                if (glm::dot(off, off) > limit_) return false;
            }
        }
        return true;
    }

    // One step of Newton's method towards the points of the curve nearest to the samples.
    void improve(const Stretch& stretch, const Bezier& curve, std::vector<double>& at) const {
        const dvec2 d0 = 3.0 * (curve[1] - curve[0]);
        const dvec2 d1 = 3.0 * (curve[2] - curve[1]);
        const dvec2 d2 = 3.0 * (curve[3] - curve[2]);
        for (std::size_t i = 1; i + 1 < at.size(); ++i) {
            const double t = at[i];
            const double s = 1.0 - t;
            const dvec2 off = pointAt(curve, t) - samples_[stretch.first + i];
            const dvec2 slope = s * s * d0 + 2.0 * s * t * d1 + t * t * d2;
            const dvec2 bend = 2.0 * (s * (d1 - d0) + t * (d2 - d1));
            const double denominator = glm::dot(slope, slope) + glm::dot(off, bend);
            if (std::abs(denominator) > 1e-12) at[i] = std::clamp(t - glm::dot(off, slope) / denominator, 0.0, 1.0);
        }
        for (std::size_t i = 1; i < at.size(); ++i) at[i] = std::max(at[i], at[i - 1]);  // samples keep their order
    }

    std::span<const dvec2> samples_;
    double tolerance_;
    double limit_;
    std::vector<Bezier>& curves_;
};

// The points of a line without repetitions; of a closed line, the first again at the end.
struct Path {
    std::vector<dvec2> points;
    bool closed;
};

Path pathOf(const Line& line) {
    Path path{{}, line.closed};
    const auto add = [&](dvec2 p) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
        if (path.points.empty() || path.points.back() != p) path.points.push_back(p);
    };
    for (const LinePoint& p : line.points) add(p.pixel);
    if (path.points.size() < 3) path.closed = false;
    if (path.closed) add(path.points.front());
    return path;
}

// Corners of a line, as indices of its points. The ends are included unless the line is closed and smooth there.
// @param plain  indices of the points that are left once the line is simplified
std::vector<std::size_t> cornersOf(const Path& path, const std::vector<std::size_t>& plain, double tolerance) {
    const auto point = [&](std::size_t i) { return path.points[plain[i]]; };
    const std::size_t last = plain.size() - 1;
    std::vector<std::size_t> corners;
    if (!path.closed || isCorner(point(last - 1), point(0), point(1), tolerance)) corners.push_back(plain.front());
    for (std::size_t i = 1; i < last; ++i) {
        if (isCorner(point(i - 1), point(i), point(i + 1), tolerance)) corners.push_back(plain[i]);
    }
    if (!path.closed) corners.push_back(plain.back());
    return corners;
}

// Indices of the points that a simplified line keeps, the first and the last included.
std::vector<std::size_t> simplified(const Path& path, double tolerance) {
    Line numbered;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        numbered.points.push_back({path.points[i], {static_cast<double>(i), 0.0, 0.0}});
    }
    if (path.closed) {
        numbered.closed = true;
        numbered.points.pop_back();
    }
    std::vector<std::size_t> kept;
    for (const LinePoint& p : simplify(numbered, tolerance).points)
        kept.push_back(static_cast<std::size_t>(p.position.x));
    if (path.closed) kept.push_back(path.points.size() - 1);
    return kept;
}

// The points from one index to another, with more points between those that are far apart.
std::vector<dvec2> sampled(const std::vector<dvec2>& points, std::size_t first, std::size_t last) {
    std::vector<dvec2> samples{points[first]};
    for (std::size_t i = first; i < last; ++i) {
        const double parts = std::clamp(std::ceil(glm::distance(points[i], points[i + 1]) / sampleStep), 1.0, 1e5);
        for (double k = 1.0; k <= parts; ++k) {
            samples.push_back(k == parts ? points[i + 1] : glm::mix(points[i], points[i + 1], k / parts));
        }
    }
    return samples;
}

// Closed paths that have a corner begin at it.
void beginAt(Path& path, std::size_t corner) {
    path.points.pop_back();
    std::rotate(path.points.begin(), path.points.begin() + static_cast<std::ptrdiff_t>(corner), path.points.end());
    path.points.push_back(path.points.front());
}

}  // namespace

dvec2 pointAt(const Bezier& curve, double t) noexcept {
    const double s = 1.0 - t;
    return s * s * s * curve[0] + 3.0 * s * s * t * curve[1] + 3.0 * s * t * t * curve[2] + t * t * t * curve[3];
}

std::vector<Bezier> fitBeziers(const Line& line, double tolerance) {
    Path path = pathOf(line);
    if (path.points.empty()) return {};
    if (path.points.size() == 1) {
        const dvec2 p = path.points.front();
        return line.points.size() < 2 ? std::vector<Bezier>{} : std::vector<Bezier>{{p, p, p, p}};
    }
    // Both steps deviate from the line, so that each gets half the tolerance: simplification, which separates corners
    // from noise, and the fitted curve.
    const double noise = 0.5 * tolerance;
    std::vector<std::size_t> plain = simplified(path, noise);
    std::vector<std::size_t> corners = cornersOf(path, plain, tolerance);
    if (path.closed && !corners.empty()) {
        beginAt(path, corners.front());
        plain = simplified(path, noise);
        path.closed = false;  // from here on: its ends meet in a corner
        corners = cornersOf(path, plain, tolerance);
    }

    std::vector<Bezier> curves;
    if (path.closed) {
        const std::vector<dvec2> samples = sampled(path.points, 0, path.points.size() - 1);
        const std::size_t reach = std::min<std::size_t>(samples.size() / 2, 3);
        const dvec2 seam = unitOr(samples[reach] - samples[samples.size() - 1 - reach], {1.0, 0.0});
        StretchFitter{samples, 0.9 * tolerance, curves}.fit(seam);
        return curves;
    }
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const auto next = std::ranges::upper_bound(plain, corners[i - 1]);
        if (*next == corners[i]) {  // nothing between: straight within the noise
            const dvec2 a = path.points[corners[i - 1]];
            const dvec2 b = path.points[corners[i]];
            curves.push_back({a, a + (b - a) / 3.0, b - (b - a) / 3.0, b});
            continue;
        }
        StretchFitter{sampled(path.points, corners[i - 1], corners[i]), 0.9 * tolerance, curves}.fit(dvec2{0.0});
    }
    return curves;
}

}  // namespace inkedge::curves
