#include "lines/see/visible_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

constexpr double fine = 0.25;     // pixels: the precision of a change; shorter pieces are not looked at
constexpr double lookBack = 0.5;  // pixels from a change to where the chain is looked at again

// The pixels of a segment that are looked at. No picture shows more than a share of one that is far longer than itself,
// as in a view that is magnified a million times: the longer, the coarser.
double lookedAt(double pixels) {
    constexpr double longest = 1e5;
    constexpr double shortest = 100.0;
    return pixels <= longest ? pixels : std::max(shortest, longest * (longest / pixels));
}

class ChainDivider {
public:
    ChainDivider(const Chain& chain, std::span<const ScreenSegment> segments, std::span<const Crossing> crossings,
                 std::span<const std::uint32_t> firstCrossings, const Judge& judge)
        : chain_{chain},
          segments_{segments},
          crossings_{crossings},
          firstCrossings_{firstCrossings},
          judge_{judge},
          lengths_{0.0} {
        for (const Chain::Link& link : chain.links) {
            const ScreenSegment& s = segments[link.segment];
            lengths_.push_back(lengths_.back() + lookedAt(glm::length(s.ends[1].pixel - s.ends[0].pixel)));
        }
    }

    std::vector<Part> part() {
        double begin = 0.0;
        for (std::size_t i = 0; i < chain_.links.size(); ++i) {
            const Chain::Link link = chain_.links[i];
            const auto own = crossings_.subspan(firstCrossings_[link.segment],
                                                firstCrossings_[link.segment + 1] - firstCrossings_[link.segment]);
            const auto visit = [&](const Crossing& crossing) {
                const double at = static_cast<double>(i) + (link.reversed ? 1.0 - crossing.at : crossing.at);
                judgePiece(begin, at);
                begin = at;
            };
            if (link.reversed) {
                std::for_each(own.rbegin(), own.rend(), visit);
            } else {
                std::for_each(own.begin(), own.end(), visit);
            }
        }
        judgePiece(begin, static_cast<double>(chain_.links.size()));
        settleUnjudged();
        settleEnds();
        clean();
        return std::move(parts_);
    }

private:
    [[nodiscard]] double lengthAt(double position) const {
        const auto count = static_cast<double>(chain_.links.size());
        if (position > count) return lengths_.back() + lengthAt(position - count);
        const auto i = std::min(static_cast<std::size_t>(position), chain_.links.size() - 1);
        return lengths_[i] + (position - static_cast<double>(i)) * (lengths_[i + 1] - lengths_[i]);
    }
    [[nodiscard]] double positionAt(double length) const {
        const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
        const auto i = static_cast<std::size_t>(after - lengths_.begin()) - 1;
        const double own = lengths_[i + 1] - lengths_[i];
        return static_cast<double>(i) + (own > 0.0 ? std::clamp((length - lengths_[i]) / own, 0.0, 1.0) : 0.5);
    }
    [[nodiscard]] Seen judge(double length) const {
        const double position = positionAt(length);
        const auto i = std::min(static_cast<std::size_t>(position), chain_.links.size() - 1);
        const double at = position - static_cast<double>(i);
        const Chain::Link link = chain_.links[i];
        return judge_(link.segment, link.reversed ? 1.0 - at : at);
    }

    void add(double begin, double end, Seen seen) {
        if (!parts_.empty() && parts_.back().seen == seen && unjudged_.back() == false) {
            parts_.back().end = end;
        } else {
            parts_.push_back({begin, end, seen});
            unjudged_.push_back(false);
        }
    }

    void judgePiece(double beginPosition, double endPosition) {
        const double begin = lengthAt(beginPosition);
        const double end = lengthAt(endPosition);
        if (end - begin < fine) {
            if (endPosition > beginPosition) {
                parts_.push_back({beginPosition, endPosition, Seen::Hidden});
                unjudged_.push_back(true);
            }
            return;
        }
        const int samples = std::max(1, static_cast<int>(std::ceil((end - begin) / sampleStep)));
        double from = beginPosition;
        double before = 0.0;
        Seen seen{};
        for (int i = 0; i < samples; ++i) {
            const double length = begin + (i + 0.5) * (end - begin) / samples;
            const Seen now = judge(length);
            if (i > 0 && now != seen) {
                const double change = positionAt(bisect(before, length, seen));
                add(from, change, seen);
                from = change;
            }
            seen = now;
            before = length;
        }
        add(from, endPosition, seen);
    }

    // The length between two others at which the chain is no longer seen as at the first.
    [[nodiscard]] double bisect(double low, double high, Seen atLow) const {
        while (high - low > fine) {
            const double middle = 0.5 * (low + high);
            (judge(middle) == atLow ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    // Pieces too short to look at are seen as the part before them or, at the chain's start, after them.
    void settleUnjudged() {
        if (parts_.empty()) return;
        const auto first = std::find(unjudged_.begin(), unjudged_.end(), false);
        if (first == unjudged_.end()) {  // all pieces are too short
            const double whole = lengths_.back();
            const Seen seen = judge(0.5 * whole);
            parts_ = {{0.0, static_cast<double>(chain_.links.size()), seen}};
            return;
        }
        Seen last = parts_[static_cast<std::size_t>(first - unjudged_.begin())].seen;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            if (unjudged_[i]) parts_[i].seen = last;
            last = parts_[i].seen;
        }
        joinAlike();
    }

    // A chain may also turn behind its own faces, at a joint and without a crossing: a part whose last bit is not seen
    // as its samples are ends before that.
    void settleEnds() {
        std::vector<Part> settled;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Part& part = parts_[i];
            const auto changes = [&](std::size_t j) { return isSeen(parts_[j].seen) != isSeen(part.seen); };
            const double begin = lengthAt(part.begin);
            const double end = lengthAt(part.end);
            const double head = i > 0 && changes(i - 1) ? settledEnd(begin, end, part.seen) : begin;
            const double tail = i + 1 < parts_.size() && changes(i + 1) ? settledEnd(end, head, part.seen) : end;
            const double first = head > begin ? positionAt(head) : part.begin;
            const double last = tail < end ? positionAt(tail) : part.end;
            if (head > begin) settled.push_back({part.begin, first, parts_[i - 1].seen});
            settled.push_back({first, last, part.seen});
            if (tail < end) settled.push_back({last, part.end, parts_[i + 1].seen});
        }
        parts_ = std::move(settled);
        joinAlike();
    }

    // The length, from an end of a part towards another length, from which on the part is seen as it should be; the end
    // itself if the part is, or is too short to be looked at.
    [[nodiscard]] double settledEnd(double end, double other, Seen seen) const {
        const double step = other > end ? lookBack : -lookBack;
        const int maxSteps =
            static_cast<int>(std::min(0.5 * std::abs(other - end), 0.5 * sampleStep + lookBack) / lookBack);
        int steps = 0;
        while (steps < maxSteps && isSeen(judge(end + (steps + 1) * step)) != isSeen(seen)) ++steps;
        return steps == 0 ? end : end + (steps + 0.5) * step;
    }

    void joinAlike() {
        std::vector<Part> merged;
        for (const Part& part : parts_) {
            if (!merged.empty() && merged.back().seen == part.seen) {
                merged.back().end = part.end;
            } else {
                merged.push_back(part);
            }
        }
        parts_ = std::move(merged);
    }

    void merge() {
        joinAlike();
        if (chain_.closed) joinAtStart();
    }

    // The start of a closed chain is arbitrary: a part may go on over it.
    void joinAtStart() {
        const auto count = static_cast<double>(chain_.links.size());
        if (parts_.size() == 1) parts_[0] = {0.0, count, parts_[0].seen};
        if (parts_.size() < 2 || parts_.front().seen != parts_.back().seen) return;
        parts_.back().end = count + parts_.front().end;
        parts_.erase(parts_.begin());
    }

    [[nodiscard]] double length(const Part& part) const { return lengthAt(part.end) - lengthAt(part.begin); }

    // How the part before part i (step -1), or after it (step 1), is seen; none: the chain ends there.
    [[nodiscard]] std::optional<Seen> beside(std::size_t i, int step) const {
        const std::size_t count = parts_.size();
        const bool atEnd = step < 0 ? i == 0 : i + 1 == count;
        if (count == 1 || (atEnd && !chain_.closed)) return {};
        return parts_[(step < 0 ? i + count - 1 : i + 1) % count].seen;
    }

    // Hides short visible parts beside a gap that stays, so that the gap between them and the next part is not filled.
    void dropSpecksAtGaps() {
        double gap = 0.0;
        const auto visit = [&](std::size_t i) {
            const double own = length(parts_[i]);
            const bool drops = own < minPart && gap >= maxGap && !isSeen(beside(i, -1).value_or(Seen::Outline)) &&
                               !isSeen(beside(i, 1).value_or(Seen::Outline));
            if (drops) parts_[i].seen = Seen::Hidden;
            gap = parts_[i].seen == Seen::Hidden ? gap + own : 0.0;
        };
        for (std::size_t i = 0; i < parts_.size(); ++i) visit(i);
        gap = 0.0;
        for (std::size_t i = parts_.size(); i-- > 0;) visit(i);
        merge();
    }

    void clean() {
        dropSpecksAtGaps();
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const bool isShort = parts_[i].seen == Seen::Hidden && length(parts_[i]) < maxGap;
            if (isShort && beside(i, -1) && beside(i, 1)) parts_[i].seen = *beside(i, -1);
        }
        merge();
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const bool alone =
                !isSeen(beside(i, -1).value_or(Seen::Hidden)) && !isSeen(beside(i, 1).value_or(Seen::Hidden));
            if (isSeen(parts_[i].seen) && alone && parts_.size() > 1 && length(parts_[i]) < minPart)
                parts_[i].seen = Seen::Hidden;
        }
        merge();
    }

    const Chain& chain_;
    std::span<const ScreenSegment> segments_;
    std::span<const Crossing> crossings_;
    std::span<const std::uint32_t> firstCrossings_;
    const Judge& judge_;
    std::vector<double> lengths_;  // pixels from the chain's start to each joint
    std::vector<Part> parts_;
    std::vector<bool> unjudged_;  // one per part
};

}  // namespace

std::vector<Part> partChain(const Chain& chain, std::span<const ScreenSegment> segments,
                            std::span<const Crossing> crossings, std::span<const std::uint32_t> firstCrossings,
                            const Judge& judge) {
    return ChainDivider{chain, segments, crossings, firstCrossings, judge}.part();
}

}  // namespace inkedge::lines
