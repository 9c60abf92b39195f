#include "lines/bridge_gaps.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

constexpr double straightOn = 0.7;   // cosine
constexpr double nearInSpace = 4.0;  // pixels across at the ends
constexpr double samePixel = 1e-6;   // pixels
constexpr double sameWidth = 0.1;    // of the pen's

// Ends of lines: 2 i is line i's first point, 2 i + 1 its last.
class Bridger {
public:
    Bridger(std::vector<Line> lines, const Screen& screen, glm::dvec3 origin)
        : lines_{std::move(lines)}, screen_{screen}, origin_{origin}, next_(2 * lines_.size(), noEnd) {}

    std::vector<Line> bridge() {
        for (const Pair& pair : pairs()) {
            if (next_[pair.a] != noEnd || next_[pair.b] != noEnd) continue;
            next_[pair.a] = pair.b;
            next_[pair.b] = pair.a;
        }
        return join();
    }

private:
    static constexpr std::uint32_t noEnd = ~0U;

    struct Pair {
        double distance;
        std::uint32_t a;
        std::uint32_t b;
    };

    [[nodiscard]] const LinePoint& point(std::uint32_t end) const {
        const auto& points = lines_[end / 2].points;
        return end % 2 == 0 ? points.front() : points.back();
    }

    // The direction out of the line at an end, over at least a pixel.
    [[nodiscard]] glm::dvec2 outward(std::uint32_t end) const {
        const auto& points = lines_[end / 2].points;
        const glm::dvec2 from = point(end).pixel;
        for (std::size_t i = 1; i < points.size(); ++i) {
            const glm::dvec2 along = from - (end % 2 == 0 ? points[i] : points[points.size() - 1 - i]).pixel;
            const double length = glm::length(along);
            if (length >= 1.0 || (i + 1 == points.size() && length > 0.0)) return along / length;
        }
        return {0.0, 0.0};
    }

    [[nodiscard]] bool goOn(std::uint32_t a, std::uint32_t b) const {
        const Line& one = lines_[a / 2];
        const Line& other = lines_[b / 2];
        if (one.type != other.type || one.visible != other.visible || one.object != other.object) return false;
        if (std::abs(one.width - other.width) > sameWidth) return false;
        if (a / 2 == b / 2 && one.points.size() < 4) return false;
        const glm::dvec2 gap = point(b).pixel - point(a).pixel;
        const double distance = glm::length(gap);
        if (distance > maxBridge || glm::dot(outward(a), outward(b)) > -straightOn) return false;
        if (distance > 0.5 && glm::dot(outward(a), gap) < straightOn * distance) return false;
        const double apart = glm::length(point(b).position - point(a).position);
        return apart <= nearInSpace * screen_.footprint(point(a).position - origin_);
    }

    [[nodiscard]] std::vector<Pair> pairs() const {
        std::vector<std::uint32_t> ends;
        for (std::uint32_t i = 0; i < lines_.size(); ++i)
            if (!lines_[i].closed) ends.insert(ends.end(), {2 * i, 2 * i + 1});
        const auto x = [&](std::uint32_t end) { return point(end).pixel.x; };
        std::ranges::sort(ends, [&](std::uint32_t a, std::uint32_t b) { return x(a) != x(b) ? x(a) < x(b) : a < b; });
        std::vector<Pair> found;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t j = i + 1; j < ends.size() && x(ends[j]) <= x(ends[i]) + maxBridge; ++j) {
                if (std::abs(point(ends[i]).pixel.y - point(ends[j]).pixel.y) > maxBridge) continue;
                if (goOn(ends[i], ends[j]))
                    found.push_back({glm::distance(point(ends[i]).pixel, point(ends[j]).pixel), ends[i], ends[j]});
            }
        }
        std::ranges::stable_sort(found, {}, &Pair::distance);
        return found;
    }

    void append(std::uint32_t line, bool reversed, std::vector<LinePoint>& to) const {
        auto points = lines_[line].points;
        if (reversed) std::ranges::reverse(points);
        const bool meets = !to.empty() && glm::distance(to.back().pixel, points.front().pixel) <= samePixel;
        to.insert(to.end(), points.begin() + (meets ? 1 : 0), points.end());
    }

    std::vector<Line> join() {
        std::vector<Line> joined;
        std::vector<bool> taken(lines_.size(), false);
        const auto walk = [&](std::uint32_t begin) {  // starts at an end of a line, into the line
            Line line = lines_[begin / 2];
            line.points.clear();
            for (std::uint32_t end = begin;;) {
                taken[end / 2] = true;
                append(end / 2, end % 2 == 1, line.points);
                const std::uint32_t next = next_[end ^ 1U];
                if (next == noEnd) break;
                if (taken[next / 2]) {
                    line.closed = true;
                    if (glm::distance(line.points.front().pixel, line.points.back().pixel) <= samePixel)
                        line.points.pop_back();
                    break;
                }
                end = next;
            }
            joined.push_back(std::move(line));
        };
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            if (taken[i]) continue;
            if (next_[2 * i] == noEnd) {
                walk(2 * i);
            } else if (next_[2 * i + 1] == noEnd) {
                walk(2 * i + 1);
            }
        }
        for (std::uint32_t i = 0; i < lines_.size(); ++i)
            if (!taken[i]) walk(2 * i);
        return joined;
    }

    std::vector<Line> lines_;
    const Screen& screen_;
    glm::dvec3 origin_;
    std::vector<std::uint32_t> next_;  // for each end the end that it is joined with
};

}  // namespace

std::vector<Line> bridgeGaps(std::vector<Line> lines, const Screen& screen, glm::dvec3 origin) {
    return Bridger{std::move(lines), screen, origin}.bridge();
}

}  // namespace inkedge::lines
