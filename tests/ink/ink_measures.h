#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <inkedge/image.h>

/// How far drawn ink is from exact strokes. Coordinates are pixels, (0, 0) the picture's top left corner.
namespace inkedge::ink_measures {

/// A stroke's centre line.
struct Line {
    glm::dvec2 a;
    glm::dvec2 b;
    [[nodiscard]] double length() const { return glm::distance(a, b); }
    [[nodiscard]] glm::dvec2 direction() const { return (b - a) / length(); }
    [[nodiscard]] glm::dvec2 normal() const { return {-direction().y, direction().x}; }
};

inline double distance(glm::dvec2 p, const Line& line) {
    const glm::dvec2 along = line.b - line.a;
    const double t = std::clamp(glm::dot(p - line.a, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::distance(p, line.a + t * along);
}

inline glm::dvec2 centre(int x, int y) { return {x + 0.5, y + 0.5}; }

/// The part of a convex polygon where dot(p, normal) <= limit.
inline std::vector<glm::dvec2> clip(const std::vector<glm::dvec2>& polygon, glm::dvec2 normal, double limit) {
    std::vector<glm::dvec2> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i];
        const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
        const double over = glm::dot(p, normal) - limit;
        const double overNext = glm::dot(q, normal) - limit;
        if (over <= 0.0) kept.push_back(p);
        if ((over < 0.0 && overNext > 0.0) || (over > 0.0 && overNext < 0.0)) {
            kept.push_back(p + (q - p) * (over / (over - overNext)));
        }
    }
    return kept;
}

inline double area(const std::vector<glm::dvec2>& polygon) {
    double twice = 0.0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i];
        const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
        twice += p.x * q.y - p.y * q.x;
    }
    return 0.5 * std::abs(twice);
}

/// The exact share of a pixel that a band of the width along the line, endless both ways, covers.
inline double bandCoverage(int x, int y, const Line& line, double width) {
    std::vector<glm::dvec2> square{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    const glm::dvec2 n = line.normal();
    const double middle = glm::dot(line.a, n);
    return area(clip(clip(square, n, middle + 0.5 * width), -n, 0.5 * width - middle));
}

/// The share of each pixel that strokes with round caps cover, by 16 x 16 samples: to about 1/64.
inline Image<double> exactInk(Size size, std::span<const Line> lines, double width) {
    Image<double> ink{size, 1};
    std::vector<Line> near;
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            near.clear();
            bool inside = false;
            for (const Line& line : lines) {
                const double d = distance(centre(x, y), line);
                inside = inside || d < 0.5 * width - 0.75;  // half a pixel's diagonal and a little
                if (d < 0.5 * width + 0.75) near.push_back(line);
            }
            if (inside || near.empty()) {
                ink.at(x, y) = inside ? 1.0 : 0.0;
                continue;
            }
            constexpr int side = 16;
            int covered = 0;
            for (int i = 0; i < side * side; ++i) {
                const glm::dvec2 p{x + (i % side + 0.5) / side, y + (i / side + 0.5) / side};
                covered += std::ranges::any_of(near, [&](const Line& line) { return distance(p, line) <= 0.5 * width; })
                               ? 1
                               : 0;
            }
            ink.at(x, y) = static_cast<double>(covered) / (side * side);
        }
    }
    return ink;
}

/// Black on white -> the share of each pixel that ink covers.
inline Image<double> inkOf(const Image<std::uint8_t>& picture) {
    Image<double> ink{picture.size(), 1};
    std::ranges::transform(picture.pixels(), ink.mutablePixels().begin(),
                           [](std::uint8_t v) { return 1.0 - v / 255.0; });
    return ink;
}

/// The ink between two pixels' centres, linear between them.
inline double inkAt(const Image<double>& ink, glm::dvec2 p) {
    const int x = std::clamp(static_cast<int>(std::floor(p.x - 0.5)), 0, ink.size().width - 2);
    const int y = std::clamp(static_cast<int>(std::floor(p.y - 0.5)), 0, ink.size().height - 2);
    const double s = std::clamp(p.x - 0.5 - x, 0.0, 1.0);
    const double t = std::clamp(p.y - 0.5 - y, 0.0, 1.0);
    return glm::mix(glm::mix(ink.at(x, y), ink.at(x + 1, y), s), glm::mix(ink.at(x, y + 1), ink.at(x + 1, y + 1), s),
                    t);
}

/// The difference of drawn from exact coverage over the pixels that either touches.
class Difference {
public:
    void add(double drawn, double exact) {
        if (drawn == 0.0 && exact == 0.0) return;
        squares_ += (drawn - exact) * (drawn - exact);
        ++count_;
    }
    [[nodiscard]] double rms() const { return count_ == 0 ? 0.0 : std::sqrt(squares_ / count_); }
    [[nodiscard]] int count() const { return count_; }

private:
    double squares_ = 0.0;
    int count_ = 0;
};

/// The ink's width around a point on a line, as a mean under a raised cosine that is `length` long. Coverage gives it
/// without bias: the ink under the window over the window's own integral.
/// @param of  of a pixel (x, y): its coverage
template <class Coverage>
double widthAround(Size size, const Line& line, double along, double length, double reach, Coverage of) {
    const glm::dvec2 middle = line.a + along * line.direction();
    const double extent = 0.5 * length + reach + 1.0;
    double sum = 0.0;
    for (int y = std::max(0, static_cast<int>(middle.y - extent));
         y <= std::min(size.height - 1, static_cast<int>(middle.y + extent)); ++y) {
        for (int x = std::max(0, static_cast<int>(middle.x - extent));
             x <= std::min(size.width - 1, static_cast<int>(middle.x + extent)); ++x) {
            const glm::dvec2 from = centre(x, y) - middle;
            const double s = glm::dot(from, line.direction());
            if (std::abs(s) >= 0.5 * length || std::abs(glm::dot(from, line.normal())) > reach) continue;
            sum += of(x, y) * (1.0 + std::cos(2.0 * std::numbers::pi * s / length));
        }
    }
    return sum / length;
}

/// What is asked of a straight stroke away from its ends.
struct StraightStroke {
    double rms = 0.0;
    double meanWidth = 0.0;
    double minWidth = 1e9;       // along the line, each a mean over some pixels; the window's own error
    double greatestWidth = 0.0;  // on exact coverage is taken off
};

/// Measures ink along the line, its ends apart.
/// @param end  how much of each end is left out
inline StraightStroke measure(const Image<double>& ink, const Line& line, double width, double end) {
    constexpr double window = 12.0;
    StraightStroke result;
    const double reach = 0.5 * width + 2.0;
    Difference difference;
    for (int y = 0; y < ink.size().height; ++y) {
        for (int x = 0; x < ink.size().width; ++x) {
            const glm::dvec2 from = centre(x, y) - line.a;
            const double s = glm::dot(from, line.direction());
            if (s < end || s > line.length() - end || std::abs(glm::dot(from, line.normal())) > reach) continue;
            difference.add(ink.at(x, y), bandCoverage(x, y, line, width));
        }
    }
    result.rms = difference.rms();
    const auto drawn = [&](int x, int y) { return ink.at(x, y); };
    const auto error = [&](int x, int y) { return ink.at(x, y) - bandCoverage(x, y, line, width); };
    const double inner = line.length() - 2.0 * end;
    EXPECT_GT(inner, 2.0 * window) << "too little line to measure";
    EXPECT_GT(difference.count(), inner) << "no ink to measure";
    // Only over the whole length is the window's own error under a thousandth.
    result.meanWidth = widthAround(ink.size(), line, 0.5 * line.length(), inner, reach, drawn);
    for (double along = end + 0.5 * window; along <= line.length() - end - 0.5 * window; along += 1.0) {
        const double there = width + widthAround(ink.size(), line, along, window, reach, error);
        result.minWidth = std::min(result.minWidth, there);
        result.greatestWidth = std::max(result.greatestWidth, there);
    }
    return result;
}

/// The limits for a straight stroke.
inline constexpr double rmsLimit = 0.04;
inline constexpr double cornerRmsLimit = 0.08;
inline constexpr double widthLimit = 0.05;  // pixels
inline constexpr double centreLimit = 0.2;  // pixels, on average

inline void expectStraight(const StraightStroke& found, double width) {
    EXPECT_LE(found.rms, rmsLimit);
    EXPECT_NEAR(found.meanWidth, width, widthLimit);
    EXPECT_GE(found.minWidth, found.meanWidth - widthLimit);
    EXPECT_LE(found.greatestWidth, found.meanWidth + widthLimit);
}

/// Adds the pixels within a radius of a point.
inline void compareAround(const Image<double>& drawn, const Image<double>& exact, glm::dvec2 point, double radius,
                          Difference& difference) {
    for (int y = 0; y < drawn.size().height; ++y) {
        for (int x = 0; x < drawn.size().width; ++x) {
            if (glm::distance(centre(x, y), point) <= radius) difference.add(drawn.at(x, y), exact.at(x, y));
        }
    }
}

/// The maximum ink that is missing at a point of a line.
/// @param counts  whether to look at a point
template <class Counts>
double maxMissing(const Image<double>& drawn, const Image<double>& exact, const Line& line, Counts counts) {
    double maximum = 0.0;
    const int samples = static_cast<int>(4.0 * line.length());
    for (int i = 0; i <= samples; ++i) {
        const glm::dvec2 p = glm::mix(line.a, line.b, static_cast<double>(i) / samples);
        if (counts(p)) maximum = std::max(maximum, inkAt(exact, p) - inkAt(drawn, p));
    }
    return maximum;
}
inline double maxMissing(const Image<double>& drawn, const Image<double>& exact, const Line& line) {
    return maxMissing(drawn, exact, line, [](glm::dvec2) { return true; });
}

/// How far the ink's middle lies from a point, across a line there: pixels along the normal; not a number without ink.
inline double offsetAcross(const Image<double>& ink, glm::dvec2 point, glm::dvec2 normal, double reach) {
    double sum = 0.0;
    double moment = 0.0;
    for (double s = -reach; s <= reach; s += 0.1) {
        const double there = inkAt(ink, point + s * normal);
        sum += there;
        moment += s * there;
    }
    return moment / sum;
}

}  // namespace inkedge::ink_measures
