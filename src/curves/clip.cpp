#include "curves/clip.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/common.hpp>

namespace inkedge::curves {
namespace {

bool isInside(glm::dvec2 p, glm::dvec2 low, glm::dvec2 high) {
    return p.x >= low.x && p.x <= high.x && p.y >= low.y && p.y <= high.y;
}

// The part of an edge that lies in a rectangle, as shares of its length; Liang and Barsky 1984.
std::optional<std::pair<double, double>> inside(glm::dvec2 a, glm::dvec2 b, glm::dvec2 low, glm::dvec2 high) {
    double enter = 0.0;
    double leave = 1.0;
    for (int k = 0; k < 2; ++k) {
        const double step = b[k] - a[k];
        if (!std::isfinite(step)) return std::nullopt;
        if (step == 0.0) {
            if (a[k] < low[k] || a[k] > high[k]) return std::nullopt;
            continue;
        }
        const double toLow = (low[k] - a[k]) / step;
        const double toHigh = (high[k] - a[k]) / step;
        enter = std::max(enter, std::min(toLow, toHigh));
        leave = std::min(leave, std::max(toLow, toHigh));
    }
    if (enter > leave) return std::nullopt;
    return std::pair{enter, leave};
}

LinePoint between(const LinePoint& a, const LinePoint& b, double share) {
    if (share == 0.0) return a;
    if (share == 1.0) return b;
    return {glm::mix(a.pixel, b.pixel, share), glm::mix(a.position, b.position, share),
            glm::mix(a.strength, b.strength, share)};
}

Line emptyLike(const Line& line) {
    return {.type = line.type,
            .visible = line.visible,
            .id = line.id,
            .object = line.object,
            .patch = line.patch,
            .points = {},
            .width = line.width};
}

}  // namespace

std::vector<Line> clip(const Line& line, glm::dvec2 low, glm::dvec2 high) {
    const std::vector<LinePoint>& points = line.points;
    if (points.size() < 2) return {};
    if (std::ranges::all_of(points, [&](const LinePoint& p) { return isInside(p.pixel, low, high); })) return {line};

    std::vector<Line> parts;
    bool goesOn = false;  // the last part ends where the next edge begins
    const std::size_t edges = line.closed ? points.size() : points.size() - 1;
    for (std::size_t i = 0; i < edges; ++i) {
        const LinePoint& a = points[i];
        const LinePoint& b = points[(i + 1) % points.size()];
        const auto shares = inside(a.pixel, b.pixel, low, high);
        if (!shares) {
            goesOn = false;
            continue;
        }
        if (!goesOn || shares->first > 0.0) {
            parts.push_back(emptyLike(line));
            parts.back().points.push_back(between(a, b, shares->first));
        }
        parts.back().points.push_back(between(a, b, shares->second));
        goesOn = shares->second == 1.0;
    }
    const bool startsInside = isInside(points.front().pixel, low, high);
    if (line.closed && startsInside && goesOn && parts.size() > 1) {  // the last part goes on as the first
        std::vector<LinePoint>& last = parts.back().points;
        last.insert(last.end(), parts.front().points.begin() + 1, parts.front().points.end());
        std::swap(parts.front(), parts.back());
        parts.pop_back();
    }
    return parts;
}

}  // namespace inkedge::curves
