#include "curves/simplify.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

namespace inkedge::curves {
namespace {

// Points between two that are kept in any case. Without such points a line could take time in the square of its points.
constexpr std::size_t longestChain = 1024;

bool isFinite(const LinePoint& p) { return std::isfinite(p.pixel.x) && std::isfinite(p.pixel.y); }

double squaredDistance(glm::dvec2 p, glm::dvec2 from, glm::dvec2 to) {
    const glm::dvec2 along = to - from;
    const double length = glm::dot(along, along);
    const double t = length > 0.0 ? std::clamp(glm::dot(p - from, along) / length, 0.0, 1.0) : 0.0;
    const glm::dvec2 offset = p - (from + t * along);
    return glm::dot(offset, offset);
}

std::size_t furthestFrom(const std::vector<LinePoint>& points, glm::dvec2 pixel) {
    const auto far = std::ranges::max_element(
        points, {}, [&](const LinePoint& p) { return glm::dot(p.pixel - pixel, p.pixel - pixel); });
    return static_cast<std::size_t>(far - points.begin());
}

}  // namespace

void keepBetween(std::span<const glm::dvec2> points, std::size_t first, std::size_t last, double tolerance,
                 std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        double largest = tolerance * tolerance;
        std::size_t furthest = from;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double d = squaredDistance(points[i], points[from], points[to]);
            if (d <= largest) continue;
            largest = d;
            furthest = i;
        }
        if (furthest == from) continue;
        kept[furthest] = true;
        open.emplace_back(from, furthest);
        open.emplace_back(furthest, to);
    }
}

Line simplify(const Line& line, double tolerance) {
    Line result = line;
    std::erase_if(result.points, [](const LinePoint& p) { return !isFinite(p); });
    if (result.points.size() < 3) return result;

    std::vector<LinePoint> points = std::move(result.points);
    if (line.closed) points.push_back(points.front());
    std::vector<std::size_t> anchors{0, points.size() - 1};  // kept in any case
    if (line.closed) anchors.push_back(furthestFrom(points, points.front().pixel));
    for (std::size_t i = longestChain; i < points.size(); i += longestChain) anchors.push_back(i);
    std::ranges::sort(anchors);

    std::vector<glm::dvec2> pixels(points.size());
    std::ranges::transform(points, pixels.begin(), &LinePoint::pixel);
    std::vector<bool> kept(points.size(), false);
    for (const std::size_t anchor : anchors) kept[anchor] = true;
    for (std::size_t i = 1; i < anchors.size(); ++i) {
        keepBetween(pixels, anchors[i - 1], anchors[i], tolerance, kept);
    }
    if (line.closed) kept.back() = false;  // the first again
    result.points.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (kept[i]) result.points.push_back(points[i]);
    }
    if (result.points.size() == 1) result.points.push_back(result.points.front());  // a closed line without extent
    return result;
}

}  // namespace inkedge::curves
