#include "lines/see/visible_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace inkedge::lines {
namespace {

constexpr double fine = 0.25;     // pixels: how closely a change is placed; shorter pieces are not looked at
constexpr double lookBack = 0.5;  // pixels from a change to where it is looked at again

class ChainParter {
public:
    ChainParter(const Chain& chain, std::span<const ScreenSegment> segments, std::span<const Crossing> crossings,
                std::span<const std::uint32_t> firstCrossings, const Judge& judge)
        : chain_{chain},
          segments_{segments},
          crossings_{crossings},
          firstCrossings_{firstCrossings},
          judge_{judge},
          lengths_{0.0} {
        for (const Chain::Link& link : chain.links) {
            const ScreenSegment& s = segments[link.segment];
            lengths_.push_back(lengths_.back() + glm::length(s.ends[1].pixel - s.ends[0].pixel));
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
    [[nodiscard]] double lengthAt(double place) const {
        const auto count = static_cast<double>(chain_.links.size());
        if (place > count) return lengths_.back() + lengthAt(place - count);
        const auto i = std::min(static_cast<std::size_t>(place), chain_.links.size() - 1);
        return lengths_[i] + (place - static_cast<double>(i)) * (lengths_[i + 1] - lengths_[i]);
    }
    [[nodiscard]] double placeAt(double length) const {
        const auto after = std::upper_bound(lengths_.begin() + 1, lengths_.end() - 1, length);
        const auto i = static_cast<std::size_t>(after - lengths_.begin()) - 1;
        const double own = lengths_[i + 1] - lengths_[i];
        return static_cast<double>(i) + (own > 0.0 ? std::clamp((length - lengths_[i]) / own, 0.0, 1.0) : 0.5);
    }
    [[nodiscard]] Seen judge(double length) const {
        const double place = placeAt(length);
        const auto i = std::min(static_cast<std::size_t>(place), chain_.links.size() - 1);
        const double at = place - static_cast<double>(i);
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

    void judgePiece(double beginPlace, double endPlace) {
        const double begin = lengthAt(beginPlace);
        const double end = lengthAt(endPlace);
        if (end - begin < fine) {
            if (endPlace > beginPlace) {
                parts_.push_back({beginPlace, endPlace, Seen::Hidden});
                unjudged_.push_back(true);
            }
            return;
        }
        const int samples = std::max(1, static_cast<int>(std::ceil((end - begin) / sampleStep)));
        double from = beginPlace;
        double before = 0.0;
        Seen seen{};
        for (int i = 0; i < samples; ++i) {
            const double length = begin + (i + 0.5) * (end - begin) / samples;
            const Seen now = judge(length);
            if (i > 0 && now != seen) {
                const double change = placeAt(bisect(before, length, seen));
                add(from, change, seen);
                from = change;
            }
            seen = now;
            before = length;
        }
        add(from, endPlace, seen);
    }

    // Where between two lengths it is no longer as at the first.
    [[nodiscard]] double bisect(double low, double high, Seen atLow) const {
        while (high - low > fine) {
            const double middle = 0.5 * (low + high);
            (judge(middle) == atLow ? low : high) = middle;
        }
        return 0.5 * (low + high);
    }

    // Pieces too short to look at are as what comes before them, or after.
    void settleUnjudged() {
        if (parts_.empty()) return;
        const auto first = std::find(unjudged_.begin(), unjudged_.end(), false);
        if (first == unjudged_.end()) {  // a chain of specks
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

    // A chain may also turn behind its own faces, at a joint and without a crossing: where a part's last bit is not as
    // its samples are, it ends before.
    void settleEnds() {
        std::vector<Part> settled;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const Part& part = parts_[i];
            const auto changes = [&](std::size_t j) { return isSeen(parts_[j].seen) != isSeen(part.seen); };
            const double begin = lengthAt(part.begin);
            const double end = lengthAt(part.end);
            const double head = i > 0 && changes(i - 1) ? strayFrom(begin, end, part.seen) : begin;
            const double tail = i + 1 < parts_.size() && changes(i + 1) ? strayFrom(end, head, part.seen) : end;
            const double first = head > begin ? placeAt(head) : part.begin;
            const double last = tail < end ? placeAt(tail) : part.end;
            if (head > begin) settled.push_back({part.begin, first, parts_[i - 1].seen});
            settled.push_back({first, last, part.seen});
            if (tail < end) settled.push_back({last, part.end, parts_[i + 1].seen});
        }
        parts_ = std::move(settled);
        joinAlike();
    }

    // How far from its end, towards another length, a part is not as it ought to be: the end itself where it is, or is
    // too short to tell.
    [[nodiscard]] double strayFrom(double end, double other, Seen seen) const {
        const double step = other > end ? lookBack : -lookBack;
        const int most =
            static_cast<int>(std::min(0.5 * std::abs(other - end), 0.5 * sampleStep + lookBack) / lookBack);
        int strays = 0;
        while (strays < most && isSeen(judge(end + (strays + 1) * step)) != isSeen(seen)) ++strays;
        return strays == 0 ? end : end + (strays + 0.5) * step;
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

    // A closed chain begins anywhere: no part of it ends there.
    void joinAtStart() {
        const auto count = static_cast<double>(chain_.links.size());
        if (parts_.size() == 1) parts_[0] = {0.0, count, parts_[0].seen};
        if (parts_.size() < 2 || parts_.front().seen != parts_.back().seen) return;
        parts_.back().end = count + parts_.front().end;
        parts_.erase(parts_.begin());
    }

    [[nodiscard]] double length(const Part& part) const { return lengthAt(part.end) - lengthAt(part.begin); }

    // What is seen before part i, at -1, or after it, at 1; none: the chain ends there.
    [[nodiscard]] std::optional<Seen> beside(std::size_t i, int step) const {
        const std::size_t count = parts_.size();
        const bool atEnd = step < 0 ? i == 0 : i + 1 == count;
        if (count == 1 || (atEnd && !chain_.closed)) return {};
        return parts_[(step < 0 ? i + count - 1 : i + 1) % count].seen;
    }

    // Specks beside a gap that stays: no gap is filled from what goes on to them.
    void dropSpecksAtGaps() {
        double gap = 0.0;
        const auto visit = [&](std::size_t i) {
            const double own = length(parts_[i]);
            const bool drops = own < leastPart && gap >= longestGap && !isSeen(beside(i, -1).value_or(Seen::Outline)) &&
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
            const bool isShort = parts_[i].seen == Seen::Hidden && length(parts_[i]) < longestGap;
            if (isShort && beside(i, -1) && beside(i, 1)) parts_[i].seen = *beside(i, -1);
        }
        merge();
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            const bool alone =
                !isSeen(beside(i, -1).value_or(Seen::Hidden)) && !isSeen(beside(i, 1).value_or(Seen::Hidden));
            if (isSeen(parts_[i].seen) && alone && parts_.size() > 1 && length(parts_[i]) < leastPart)
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
    std::vector<bool> unjudged_;  // one a part
};

}  // namespace

std::vector<Part> partChain(const Chain& chain, std::span<const ScreenSegment> segments,
                            std::span<const Crossing> crossings, std::span<const std::uint32_t> firstCrossings,
                            const Judge& judge) {
    return ChainParter{chain, segments, crossings, firstCrossings, judge}.part();
}

}  // namespace inkedge::lines
