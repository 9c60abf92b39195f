#include "lines/chains.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

constexpr double margin = 32.0;  // pixels: from there even the widest stroke does not reach the picture

bool clipToNear(Segment& segment, std::array<glm::dvec3, 2>& ends, const Screen& screen) {
    const double before[2]{screen.depth(ends[0]) - screen.near(), screen.depth(ends[1]) - screen.near()};
    if (before[0] <= 0.0 && before[1] <= 0.0) return false;
    for (std::size_t k = 0; k < 2; ++k) {
        if (before[k] > 0.0) continue;
        // Slightly behind the plane, so that the projection is finite.
        const double t = std::min(1.0, (1e-9 * screen.near() - before[k]) / (before[1 - k] - before[k]));
        ends[k] += t * (ends[1 - k] - ends[k]);
        segment.strengths[k] += t * (segment.strengths[1 - k] - segment.strengths[k]);
        segment.keys[k] = noKey;
    }
    return true;
}

bool showsIn(const ScreenSegment& s, Size size) {
    const glm::dvec2 low = glm::min(s.ends[0].pixel, s.ends[1].pixel);
    const glm::dvec2 high = glm::max(s.ends[0].pixel, s.ends[1].pixel);
    return high.x > -margin && high.y > -margin && low.x < size.width + margin && low.y < size.height + margin;
}

// Ends of segments: 2 s + k is end k of segment s.
class Chainer {
public:
    Chainer(std::span<const Segment> segments, std::span<const ScreenSegment> screen)
        : segments_{segments}, screen_{screen}, next_(2 * segments.size(), noEnd) {}

    std::vector<Chain> chain() {
        std::vector<std::uint32_t> ends;
        for (std::uint32_t s = 0; s < segments_.size(); ++s) {
            if (!segments_[s].drawn) continue;
            for (std::uint32_t k = 0; k < 2; ++k)
                if (segments_[s].keys[k] != noKey) ends.push_back(2 * s + k);
        }
        std::ranges::sort(ends, [&](std::uint32_t a, std::uint32_t b) {
            if (kind(a) != kind(b)) return kind(a) < kind(b);
            return key(a) != key(b) ? key(a) < key(b) : a < b;
        });
        for (auto run = ends.begin(); run != ends.end();) {
            const auto end = std::find_if(
                run, ends.end(), [&](std::uint32_t e) { return key(e) != key(*run) || kind(e) != kind(*run); });
            joinAt({run, end});
            run = end;
        }
        return follow();
    }

private:
    static constexpr std::uint32_t noEnd = ~0U;

    [[nodiscard]] std::tuple<Curve, bool, bool> kind(std::uint32_t end) const {
        const Segment& segment = segments_[end / 2];
        return {segment.curve, segment.marked, segment.hidden};
    }
    [[nodiscard]] Key key(std::uint32_t end) const { return segments_[end / 2].keys[end % 2]; }
    [[nodiscard]] glm::dvec2 pixel(std::uint32_t end) const { return screen_[end / 2].ends[end % 2].pixel; }
    [[nodiscard]] glm::dvec2 away(std::uint32_t end) const {
        const glm::dvec2 along = pixel(end ^ 1U) - pixel(end);
        const double length = glm::length(along);
        return length > 0.0 ? along / length : glm::dvec2{0.0};
    }

    void link(std::uint32_t a, std::uint32_t b) {
        next_[a] = b;
        next_[b] = a;
    }

    // Joins the segments that end at one key.
    void joinAt(std::span<const std::uint32_t> ends) {
        if (ends.size() == 2) link(ends[0], ends[1]);
        if (ends.size() < 3) return;
        struct Pair {
            double cosine;  // -1: straight on
            std::uint32_t a;
            std::uint32_t b;
        };
        constexpr double maxBendCosine = -0.5;
        constexpr std::size_t maxEnds = 32;  // where more meet none are joined
        if (ends.size() > maxEnds) return;
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            for (std::size_t j = i + 1; j < ends.size(); ++j) {
                const double cosine = glm::dot(away(ends[i]), away(ends[j]));
                if (cosine < maxBendCosine) pairs.push_back({cosine, ends[i], ends[j]});
            }
        }
        std::ranges::stable_sort(pairs, {}, &Pair::cosine);
        for (const Pair& pair : pairs)
            if (next_[pair.a] == noEnd && next_[pair.b] == noEnd) link(pair.a, pair.b);
    }

    std::vector<Chain> follow() {
        std::vector<Chain> chains;
        std::vector<bool> taken(segments_.size(), false);
        const auto walk = [&](std::uint32_t begin) {  // starts at an end of a segment, into the segment
            Chain chain;
            for (std::uint32_t end = begin;;) {
                taken[end / 2] = true;
                chain.links.push_back({end / 2, end % 2 == 1});
                const std::uint32_t next = next_[end ^ 1U];
                if (next == noEnd) break;
                if (taken[next / 2]) {
                    chain.closed = true;
                    break;
                }
                end = next;
            }
            chains.push_back(std::move(chain));
        };
        for (std::uint32_t s = 0; s < segments_.size(); ++s) {
            if (!segments_[s].drawn || taken[s]) continue;
            if (next_[2 * s] == noEnd) {
                walk(2 * s);
            } else if (next_[2 * s + 1] == noEnd) {
                walk(2 * s + 1);
            }
        }
        for (std::uint32_t s = 0; s < segments_.size(); ++s)
            if (segments_[s].drawn && !taken[s]) walk(2 * s);
        return chains;
    }

    std::span<const Segment> segments_;
    std::span<const ScreenSegment> screen_;
    std::vector<std::uint32_t> next_;  // for each end the end of another segment that it is joined with
};

}  // namespace

std::vector<ScreenSegment> project(std::vector<Segment>& segments, const Screen& screen) {
    std::vector<ScreenSegment> projected;
    projected.reserve(segments.size());
    std::erase_if(segments, [&](Segment& segment) {
        std::array<glm::dvec3, 2> world = segment.ends;
        if (!clipToNear(segment, world, screen)) return true;
        const ScreenSegment s{{screen.project(world[0]), screen.project(world[1])}, world};
        if (!showsIn(s, screen.size())) return true;
        projected.push_back(s);
        return false;
    });
    return projected;
}

std::vector<Chain> chainSegments(std::span<const Segment> segments, std::span<const ScreenSegment> screen) {
    return Chainer{segments, screen}.chain();
}

}  // namespace inkedge::lines
