#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <inkedge/lines.h>

/// Lines made by hand, and how far points are from them.
namespace inkedge::curves {

inline Line lineThrough(const std::vector<glm::dvec2>& pixels) {
    Line line;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        line.points.push_back({pixels[i], {static_cast<double>(i), pixels[i]}});  // x: the index of the point
    }
    return line;
}

inline Line closedThrough(const std::vector<glm::dvec2>& pixels) {
    Line line = lineThrough(pixels);
    line.closed = true;
    return line;
}

inline Line circle(glm::dvec2 centre, double radius, int points) {
    std::vector<glm::dvec2> pixels;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points + 0.1;
        pixels.push_back(centre + radius * glm::dvec2{std::cos(angle), std::sin(angle)});
    }
    return closedThrough(pixels);
}

inline double distanceToEdge(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double length = glm::dot(along, along);
    const double t = length > 0.0 ? std::clamp(glm::dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    return glm::distance(p, a + t * along);
}

inline std::vector<glm::dvec2> outlineOf(const Line& line) {
    std::vector<glm::dvec2> pixels;
    for (const LinePoint& p : line.points) pixels.push_back(p.pixel);
    if (line.closed) pixels.push_back(pixels.front());
    return pixels;
}

inline double distanceTo(const std::vector<glm::dvec2>& chain, glm::dvec2 p) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < chain.size(); ++i)
        smallest = std::min(smallest, distanceToEdge(p, chain[i - 1], chain[i]));
    return smallest;
}

/// Points on a chain, about step apart, its points included.
inline std::vector<glm::dvec2> sampled(const std::vector<glm::dvec2>& chain, double step) {
    std::vector<glm::dvec2> samples{chain.front()};
    for (std::size_t i = 1; i < chain.size(); ++i) {
        const double parts = std::max(1.0, std::ceil(glm::distance(chain[i - 1], chain[i]) / step));
        for (double k = 1.0; k <= parts; ++k) samples.push_back(glm::mix(chain[i - 1], chain[i], k / parts));
    }
    return samples;
}

/// How far the one strays from the other at largest, in both directions, by samples step apart.
inline double furthest(const std::vector<glm::dvec2>& a, const std::vector<glm::dvec2>& b, double step) {
    double largest = 0.0;
    for (const glm::dvec2 p : sampled(a, step)) largest = std::max(largest, distanceTo(b, p));
    for (const glm::dvec2 p : sampled(b, step)) largest = std::max(largest, distanceTo(a, p));
    return largest;
}

/// A winding line with smooth bends, straight runs and some noise.
inline Line winding(int points, double noise, unsigned seed) {
    std::vector<glm::dvec2> pixels;
    unsigned state = seed;
    const auto random = [&] {
        state = state * 1664525U + 1013904223U;
        return (state >> 8U) / static_cast<double>(1U << 24U) - 0.5;
    };
    for (int i = 0; i < points; ++i) {
        const double t = static_cast<double>(i) / points;
        pixels.push_back({500.0 * t + 30.0 * std::sin(9.0 * t + 0.1 * seed) + noise * random(),
                          200.0 + 80.0 * std::sin(14.0 * t) * std::cos(5.0 * t + seed) + noise * random()});
    }
    return lineThrough(pixels);
}

}  // namespace inkedge::curves
