#include "lines/specks.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/union_find.h"

namespace inkedge::lines {
namespace {

// Up to a limit, beyond which it says nothing more.
double lengthOf(const Line& line, double limit) {
    double length = line.closed ? glm::distance(line.points.back().pixel, line.points.front().pixel) : 0.0;
    for (std::size_t i = 0; i + 1 < line.points.size() && length < limit; ++i)
        length += glm::distance(line.points[i].pixel, line.points[i + 1].pixel);
    return length;
}

// Points in the picture, each with a number, found again by what is near them.
class NearPoints {
public:
    void add(glm::dvec2 pixel, std::uint32_t number) {
        for (int dx = -1; dx <= 1; ++dx)
            for (int dy = -1; dy <= 1; ++dy) entries_.push_back({cellOf(pixel, dx, dy), pixel, number});
    }

    void sort() {
        std::ranges::sort(entries_, {}, &Entry::cell);
        for (const Entry& entry : entries_) occupied_.set(slotOf(entry.cell));
    }

    template <class Visit>
    void forEachWithinReach(glm::dvec2 pixel, Visit visit) const {
        const std::uint64_t cell = cellOf(pixel, 0, 0);
        if (!occupied_.test(slotOf(cell))) return;  // almost always
        auto entry = std::ranges::lower_bound(entries_, cell, {}, &Entry::cell);
        for (; entry != entries_.end() && entry->cell == cell; ++entry)
            if (glm::distance(entry->pixel, pixel) <= scrapReach) visit(entry->number);
    }

private:
    struct Entry {
        std::uint64_t cell;
        glm::dvec2 pixel;
        std::uint32_t number;
    };
    static constexpr std::size_t slots = 1U << 16U;

    static std::uint64_t cellOf(glm::dvec2 pixel, int dx, int dy) {
        constexpr double limit = 1e9;  // far outside any picture
        const auto at = [](double v, int d) {
            return static_cast<std::uint32_t>(static_cast<std::int32_t>(std::floor(v / scrapReach)) + d);
        };
        const glm::dvec2 within = glm::clamp(pixel, -limit, limit);
        return (std::uint64_t{at(within.x, dx)} << 32U) | at(within.y, dy);
    }

    static std::size_t slotOf(std::uint64_t cell) { return (cell * 0x9E3779B97F4A7C15U) >> 48U; }

    std::vector<Entry> entries_;  // each point in its cell and the eight around
    std::bitset<slots> occupied_;
};

class ScrapFinder {
public:
    explicit ScrapFinder(const std::vector<Line>& lines) : lines_{lines} {
        for (std::uint32_t i = 0; i < lines.size(); ++i) {
            if (!mayBeScrap(lines[i].type)) continue;
            const double length = lengthOf(lines[i], minScrapLength);
            if (length < minScrapLength) candidates_.push_back({i, length});
        }
    }

    // Indices into the lines, ascending.
    std::vector<std::uint32_t> find() {
        if (candidates_.empty()) return {};
        for (std::uint32_t k = 0; k < candidates_.size(); ++k) {
            ends_.add(lines_[candidates_[k].line].points.front().pixel, k);
            ends_.add(lines_[candidates_[k].line].points.back().pixel, k);
        }
        ends_.sort();
        base::UnionFind groups{static_cast<std::uint32_t>(candidates_.size())};
        join(groups);
        std::vector<double> lengths(candidates_.size(), 0.0);
        for (std::uint32_t k = 0; k < candidates_.size(); ++k) lengths[groups.root(k)] += candidates_[k].length;
        const auto isShort = [&](std::uint32_t k) { return lengths[groups.root(k)] < minScrapLength; };
        const std::set<std::uint32_t> objects = objectsOfOthers(isShort);
        std::vector<std::uint32_t> scraps;
        for (std::uint32_t k = 0; k < candidates_.size(); ++k) {
            const Line& line = lines_[candidates_[k].line];
            if (isShort(k) && (line.type != LineType::Outline || objects.contains(line.object)))
                scraps.push_back(candidates_[k].line);
        }
        return scraps;
    }

private:
    struct Candidate {
        std::uint32_t line;
        double length;
    };

    // The objects of lines that are no candidates, or not short enough.
    template <class IsShort>
    [[nodiscard]] std::set<std::uint32_t> objectsOfOthers(IsShort isShort) const {
        std::set<std::uint32_t> objects;
        std::uint32_t k = 0;
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            const bool candidate = k < candidates_.size() && candidates_[k].line == i;
            if (!candidate || !isShort(k)) objects.insert(lines_[i].object);
            if (candidate) ++k;
        }
        return objects;
    }

    // Joins candidates that reach each other; one that reaches any other line counts as long.
    void join(base::UnionFind& groups) {
        auto next = candidates_.begin();
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            std::optional<std::uint32_t> own;
            if (next != candidates_.end() && next->line == i)
                own = static_cast<std::uint32_t>(next++ - candidates_.begin());
            alongLine(lines_[i], [&](glm::dvec2 pixel) {
                ends_.forEachWithinReach(pixel, [&](std::uint32_t k) {
                    if (own)
                        groups.unite(*own, k);
                    else
                        candidates_[k].length = minScrapLength;
                });
            });
        }
    }

    // Visits points along a line, a pixel apart or nearer.
    template <class Visit>
    static void alongLine(const Line& line, Visit visit) {
        visit(line.points.front().pixel);
        const std::size_t count = line.points.size();
        for (std::size_t i = 1; i < count + (line.closed ? 1 : 0); ++i) {
            const glm::dvec2 from = line.points[i - 1].pixel;
            const glm::dvec2 to = line.points[i % count].pixel;
            const double steps = std::clamp(std::ceil(glm::distance(from, to)), 1.0, 1e5);
            for (double step = 1.0; step <= steps; ++step) visit(glm::mix(from, to, step / steps));
        }
    }

    const std::vector<Line>& lines_;
    std::vector<Candidate> candidates_;
    NearPoints ends_;
};

}  // namespace

void leaveOutSpecks(std::vector<Line>& lines) {
    std::erase_if(lines, [](const Line& line) { return lengthOf(line, minLineLength) < minLineLength; });
}

void leaveOutScraps(std::vector<Line>& lines) {
    const std::vector<std::uint32_t> scraps = ScrapFinder{lines}.find();
    std::size_t kept = 0;
    auto scrap = scraps.begin();
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
        if (scrap != scraps.end() && *scrap == i) {
            ++scrap;
            continue;
        }
        if (kept != i) lines[kept] = std::move(lines[i]);
        ++kept;
    }
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(kept), lines.end());
}

}  // namespace inkedge::lines
