#include <inkedge/compare_lines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "diff/ink_of_picture.h"
#include "diff/join_ends.h"
#include "diff/samples.h"
#include "diff/skeleton.h"

namespace inkedge {
namespace diff {
namespace {

// The neighbours of a pixel: those at its sides first, so that no step goes around a corner that it could cut.
constexpr std::array<std::pair<int, int>, 8> sidesThenCorners{
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

// Follows the pixels of a skeleton from one end or fork to the next.
class Tracer {
public:
    explicit Tracer(Image<std::uint8_t> skeleton) : left_{std::move(skeleton)} {
        forks_ = Image<std::uint8_t>{left_.size(), 1};
        each([&](int x, int y) { forks_(x, y) = isOn(x, y) && ways(x, y) > 2; });
    }

    std::vector<ComparedLine> trace() {
        std::vector<ComparedLine> lines;
        const auto keep = [&](ComparedLine line) {
            if (line.points.size() > 1) lines.push_back(std::move(line));
        };
        // From forks: each of their neighbours begins a line; then from ends; what is left are loops.
        each([&](int x, int y) {
            if (!forks_(x, y)) return;
            for (const auto& [dx, dy] : sidesThenCorners)
                if (isOn(x + dx, y + dy) && !forks_(x + dx, y + dy)) keep(follow(x + dx, y + dy, {{x + 0.5, y + 0.5}}));
        });
        each([&](int x, int y) {
            if (isOn(x, y) && !forks_(x, y) && ways(x, y) <= 1) keep(follow(x, y, {}));
        });
        each([&](int x, int y) {
            if (!isOn(x, y) || forks_(x, y)) return;
            ComparedLine loop = follow(x, y, {});
            loop.closed = loop.points.size() > 3;
            keep(std::move(loop));
        });
        return lines;
    }

private:
    template <class Visit>
    void each(Visit&& visit) {
        for (int y = 0; y < left_.size().height; ++y)
            for (int x = 0; x < left_.size().width; ++x) visit(x, y);
    }

    [[nodiscard]] bool isOn(int x, int y) const {
        return x >= 0 && y >= 0 && x < left_.size().width && y < left_.size().height && left_(x, y) != 0;
    }

    // How many lines leave a pixel: stretches of neighbours in a circle.
    [[nodiscard]] int ways(int x, int y) const {
        constexpr std::array<std::pair<int, int>, 8> circle{
            {{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};
        int count = 0;
        for (std::size_t k = 0; k < 8; ++k) {
            const auto [ax, ay] = circle[k];
            const auto [bx, by] = circle[(k + 1) % 8];
            if (isOn(x + ax, y + ay) && !isOn(x + bx, y + by)) ++count;
        }
        return count;
    }

    ComparedLine follow(int x, int y, std::vector<glm::dvec2> points) {
        ComparedLine line;
        line.points = std::move(points);
        const bool fromFork = !line.points.empty();
        for (bool first = true;; first = false) {
            line.points.emplace_back(x + 0.5, y + 0.5);
            left_(x, y) = 0;
            const std::pair<int, int>* next = nullptr;
            const std::pair<int, int>* fork = nullptr;
            for (const auto& step : sidesThenCorners) {
                const int toX = x + step.first;
                const int toY = y + step.second;
                if (!isOn(toX, toY)) continue;
                if (forks_(toX, toY)) {
                    // Not back to where it comes from.
                    const bool back = first && fromFork && line.points[0] == glm::dvec2{toX + 0.5, toY + 0.5};
                    if (!back && fork == nullptr) fork = &step;
                } else if (next == nullptr) {
                    next = &step;
                }
            }
            if (fork != nullptr) {
                line.points.emplace_back(x + fork->first + 0.5, y + fork->second + 0.5);
                return line;
            }
            if (next == nullptr) return line;
            x += next->first;
            y += next->second;
        }
    }

    Image<std::uint8_t> left_;
    Image<std::uint8_t> forks_;
};

float inkAt(const Image<float>& ink, glm::dvec2 at) {
    const glm::dvec2 corner = at - 0.5;
    const glm::dvec2 low = glm::floor(corner);
    const glm::dvec2 t = corner - low;
    const auto value = [&](int dx, int dy) {
        const int x = static_cast<int>(low.x) + dx;
        const int y = static_cast<int>(low.y) + dy;
        const bool inside = x >= 0 && y >= 0 && x < ink.size().width && y < ink.size().height;
        return inside ? static_cast<double>(ink(x, y)) : 0.0;
    };
    return static_cast<float>(
        glm::mix(glm::mix(value(0, 0), value(1, 0), t.x), glm::mix(value(0, 1), value(1, 1), t.x), t.y));
}

// How far across a line its ink lies from a point: the mean of what hangs together there. Where another line meets it
// the ink goes on to that side; no more of it counts than a pixel beyond what there is to the other.
double offsetAcross(const Image<float>& ink, glm::dvec2 at, glm::dvec2 across) {
    constexpr double step = 0.25;
    constexpr std::size_t steps = 40;
    constexpr std::size_t pixel = 4;  // steps
    constexpr float edge = 0.08F;
    std::array<std::vector<float>, 2> sides;
    for (std::size_t side = 0; side < 2; ++side) {
        const glm::dvec2 stride = (side == 0 ? step : -step) * across;
        float highest = inkAt(ink, at);
        float lowest = highest;
        for (std::size_t i = 1; i <= steps; ++i) {
            const float value = inkAt(ink, at + static_cast<double>(i) * stride);
            if (value < edge || (value > lowest + edge && lowest < 0.5F * highest)) break;  // the next line begins
            highest = std::max(highest, value);
            lowest = value == highest ? value : std::min(lowest, value);
            sides[side].push_back(value);
        }
    }
    const std::size_t reach = std::min(sides[0].size(), sides[1].size()) + pixel;
    double sum = inkAt(ink, at);
    double moment = 0.0;
    for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t i = 0; i < std::min(sides[side].size(), reach); ++i) {
            sum += sides[side][i];
            moment += (side == 0 ? step : -step) * static_cast<double>(i + 1) * sides[side][i];
        }
    }
    return sum > 0.0 ? moment / sum : 0.0;
}

// Moves points to the middle of the ink and makes the steps of pixels smooth.
void refine(ComparedLine& line, const Image<float>& ink) {
    const std::vector<glm::dvec2> pixels = line.points;
    const auto count = static_cast<int>(pixels.size());
    const auto pixel = [&](int i) {
        return pixels[static_cast<std::size_t>(line.closed ? (i + count) % count : std::clamp(i, 0, count - 1))];
    };
    constexpr double farthest = 1.0;  // pixels: a skeleton is hardly farther off
    for (int i = 0; i < count; ++i) {
        const glm::dvec2 along = pixel(i + 3) - pixel(i - 3);
        if (along == glm::dvec2{0.0}) continue;
        const glm::dvec2 across = glm::normalize(glm::dvec2{-along.y, along.x});
        const double offset = offsetAcross(ink, pixel(i), across);
        line.points[static_cast<std::size_t>(i)] += std::clamp(offset, -farthest, farthest) * across;
    }
    const std::vector<glm::dvec2> middles = line.points;
    for (int i = 0; i < count; ++i) {
        if (!line.closed && (i == 0 || i + 1 == count)) continue;
        const auto middle = [&](int k) { return middles[static_cast<std::size_t>((k + count) % count)]; };
        line.points[static_cast<std::size_t>(i)] = 0.25 * middle(i - 1) + 0.5 * middle(i) + 0.25 * middle(i + 1);
    }
}

// The mean width of lines, pixels.
double widthOf(const Image<float>& ink, const Image<std::uint8_t>& skeleton) {
    double area = 0.0;
    double length = 1.0;
    for (const float value : ink.pixels()) area += value;
    for (const std::uint8_t value : skeleton.pixels()) length += value;
    return area / length;
}

}  // namespace
}  // namespace diff

ComparedLines comparedLines(const Image<float>& picture) {
    ComparedLines all{.lines = {}, .size = picture.size(), .objects = {}};
    const Image<float> ink = diff::inkOfPicture(picture);
    if (ink.empty()) return all;
    constexpr double shortest = 3.0;  // pixels: shorter ones stick out of the middle of a wide line
    const Image<std::uint8_t> skeleton = diff::skeletonOf(ink);
    const double gap = 3.0 + diff::widthOf(ink, skeleton);  // over which a line goes on where others cross it
    std::vector<ComparedLine> lines = diff::joinEnds(diff::Tracer{skeleton}.trace(), gap);
    std::erase_if(lines, [](const ComparedLine& line) { return !line.closed && diff::lengthOf(line) < shortest; });
    for (ComparedLine& line : lines) diff::refine(line, ink);
    all.lines = std::move(lines);
    return all;
}

}  // namespace inkedge
