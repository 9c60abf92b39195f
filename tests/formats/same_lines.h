#pragma once

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include <inkedge/lines.h>
#include <inkedge/views.h>

#include "lines/object_lines.h"

namespace inkedge {

/// The lines of a scene, hidden ones too, in a picture of 400 x 400 that it fills.
inline Lines linesToCompare(const Scene& scene) {
    Settings settings;
    settings.picture.size = {400, 400};
    settings.lines.hidden = HiddenLines::Dashed;
    return lines::ObjectLines{scene}.find(frameCamera(scene, {}, settings.picture.size), settings);
}

inline double distanceTo(const Line& line, glm::dvec2 p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        const glm::dvec2 a = line.points[i].pixel;
        const glm::dvec2 along = line.points[i + 1].pixel - a;
        const double square = glm::dot(along, along);
        const double share = square > 0.0 ? std::clamp(glm::dot(p - a, along) / square, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, glm::distance(p, a + share * along));
    }
    return nearest;
}

/// Expects each point of some lines on one of others, of the same type, seen or hidden alike.
inline void expectAmong(const Lines& some, const Lines& others, double pixels) {
    double farthest = 0.0;
    for (const Line& line : some.lines) {
        for (const LinePoint& point : line.points) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const Line& other : others.lines)
                if (other.type == line.type && other.visible == line.visible)
                    nearest = std::min(nearest, distanceTo(other, point.pixel));
            farthest = std::max(farthest, nearest);
        }
    }
    EXPECT_LE(farthest, pixels);
}

/// Expects as many lines, in the same places.
inline void expectSameLines(const Lines& a, const Lines& b, double pixels) {
    EXPECT_EQ(a.lines.size(), b.lines.size());
    expectAmong(a, b, pixels);
    expectAmong(b, a, pixels);
}

}  // namespace inkedge
