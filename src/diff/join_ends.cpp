#include "diff/join_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "diff/samples.h"

namespace inkedge::diff {
namespace {

constexpr double cosOfTurn = 0.8;  // of 37 degrees
constexpr double lookBack = 8.0;   // pixels along a line that say which way its end goes

// An end of a line: where it is, and which way the line would go on.
struct End {
    glm::dvec2 at;
    glm::dvec2 onward;
};

// The point of a line that is so far along it from one of its ends.
glm::dvec2 pointAt(const ComparedLine& line, bool last, double way) {
    const auto count = line.points.size();
    const auto point = [&](std::size_t i) { return line.points[last ? count - 1 - i : i]; };
    for (std::size_t i = 1; i < count; ++i) {
        const double step = glm::distance(point(i - 1), point(i));
        if (step > 0.0 && step >= way) return glm::mix(point(i - 1), point(i), way / step);
        way -= step;
    }
    return point(count - 1);
}

// Beside a fork the middle of the ink bends towards it: the last pixels of a line do not say where it goes.
End endOf(const ComparedLine& line, bool last) {
    constexpr double bent = 2.0;  // pixels
    const bool isLong = lengthOf(line) > lookBack + bent;
    const glm::dvec2 along = pointAt(line, last, isLong ? bent : 0.0) - pointAt(line, last, lookBack + bent);
    const double length = glm::length(along);
    return {pointAt(line, last, 0.0), length > 0.0 ? along / length : glm::dvec2{0.0}};
}

struct Joint {
    double turn;  // 1 less the cosine
    double gap;
    std::size_t a;  // ends: 2 * line, and 1 more for its last point
    std::size_t b;
};

std::vector<Joint> jointsOf(const std::vector<ComparedLine>& lines, const std::vector<End>& ends, double gap) {
    std::map<std::pair<int, int>, std::vector<std::size_t>> cells;
    const double cell = std::max(gap, 1.0);
    const auto cellOf = [&](glm::dvec2 at) {
        const glm::ivec2 index{glm::floor(at / cell)};
        return std::pair{index.x, index.y};
    };
    std::vector<Joint> joints;
    for (std::size_t end = 0; end < ends.size(); ++end) {
        const ComparedLine& line = lines[end / 2];
        if (line.closed) continue;
        const auto [x, y] = cellOf(ends[end].at);
        for (int dy = -1; dy <= 1; ++dy) {
            for (int dx = -1; dx <= 1; ++dx) {
                const auto found = cells.find({x + dx, y + dy});
                if (found == cells.end()) continue;
                for (const std::size_t other : found->second) {
                    const ComparedLine& with = lines[other / 2];
                    if (other / 2 == end / 2 && lengthOf(line) < 4.0 * gap) continue;  // no loop
                    if (with.type != line.type || with.visible != line.visible || with.object != line.object) continue;
                    const double distance = glm::distance(ends[end].at, ends[other].at);
                    const double cosine = -glm::dot(ends[end].onward, ends[other].onward);
                    if (distance <= gap && cosine >= cosOfTurn) joints.push_back({1.0 - cosine, distance, other, end});
                }
            }
        }
        cells[{x, y}].push_back(end);
    }
    std::ranges::sort(joints, {}, [](const Joint& j) { return std::tuple{j.turn + j.gap, j.a, j.b}; });
    return joints;
}

// Goes from one line to the next by way of joints.
class Chainer {
public:
    Chainer(std::vector<ComparedLine> lines, const std::vector<Joint>& joints)
        : lines_{std::move(lines)}, next_(2 * lines_.size(), none), used_(lines_.size(), false) {
        for (const Joint& joint : joints) {
            if (next_[joint.a] != none || next_[joint.b] != none) continue;
            next_[joint.a] = joint.b;
            next_[joint.b] = joint.a;
        }
    }

    std::vector<ComparedLine> take() {
        std::vector<ComparedLine> chains;
        for (std::size_t end = 0; end < next_.size(); ++end)
            if (!used_[end / 2] && (next_[end] == none || lines_[end / 2].closed)) chains.push_back(from(end));
        for (std::size_t line = 0; line < lines_.size(); ++line)  // what is left runs in circles
            if (!used_[line]) chains.push_back(from(2 * line));
        return chains;
    }

private:
    static constexpr std::size_t none = SIZE_MAX;

    ComparedLine from(std::size_t start) {
        ComparedLine chain = lines_[start / 2];
        chain.points.clear();
        for (std::size_t end = start;;) {
            std::vector<glm::dvec2>& points = lines_[end / 2].points;
            used_[end / 2] = true;
            if (end % 2 == 1) std::ranges::reverse(points);
            chain.points.insert(chain.points.end(), points.begin(), points.end());
            end = next_[end ^ 1U];
            if (end == none) return chain;
            if (used_[end / 2]) {
                chain.closed = true;
                return chain;
            }
        }
    }

    std::vector<ComparedLine> lines_;
    std::vector<std::size_t> next_;  // of each end, the one that it is joined to
    std::vector<bool> used_;
};

}  // namespace

std::vector<ComparedLine> joinEnds(std::vector<ComparedLine> lines, double gap) {
    std::vector<End> ends;
    for (const ComparedLine& line : lines) {
        ends.push_back(endOf(line, false));
        ends.push_back(endOf(line, true));
    }
    const std::vector<Joint> joints = jointsOf(lines, ends, gap);
    return Chainer{std::move(lines), joints}.take();
}

}  // namespace inkedge::diff
