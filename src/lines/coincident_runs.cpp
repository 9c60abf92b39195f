#include "lines/coincident_runs.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include <glm/geometric.hpp>

#include "lines/coincident.h"
#include "lines/see/visible_parts.h"

namespace inkedge::lines {
namespace {

void joinAlike(std::vector<Run>& runs) {
    std::vector<Run> joined;
    for (const Run& run : runs) {
        if (!joined.empty() && joined.back().type == run.type) {
            joined.back().end = run.end;
        } else {
            joined.push_back(run);
        }
    }
    runs = std::move(joined);
}

}  // namespace

void Stretches::add(double from, double to) {
    if (from > to) std::swap(from, to);
    auto next = stretches_.upper_bound(from);
    if (next != stretches_.begin() && std::prev(next)->second >= from) --next;
    while (next != stretches_.end() && next->first <= to) {
        from = std::min(from, next->first);
        to = std::max(to, next->second);
        next = stretches_.erase(next);
    }
    stretches_.emplace(from, to);
}

bool Stretches::hold(double position) const {
    const auto next = stretches_.upper_bound(position);
    return next != stretches_.begin() && std::prev(next)->second >= position;
}

bool Stretches::hold(double from, double to, double longestGap) const {
    auto next = stretches_.upper_bound(from + longestGap);
    if (next == stretches_.begin()) return false;
    double reached = std::prev(next)->second;
    for (; reached < to - longestGap; ++next) {
        if (next == stretches_.end() || next->first > reached + longestGap) return false;
        reached = next->second;
    }
    return true;
}

CoincidentRuns::CoincidentRuns(const Line& line, double within, double shortest)
    : own_{line.type}, closed_{line.closed}, within_{within}, shortest_{shortest}, lengths_{0.0} {
    const std::size_t count = line.points.size();
    for (std::size_t i = 0; i + (closed_ ? 0 : 1) < count; ++i)
        lengths_.push_back(lengths_.back() + glm::distance(line.points[i].pixel, line.points[(i + 1) % count].pixel));
}

void CoincidentRuns::add(double from, double to, std::optional<LineType> type) {
    if (from > to) std::swap(from, to);
    if (type) {
        typed_.push_back({from, to, type});
    } else {
        gone_.add(from, to);
    }
}

double CoincidentRuns::lengthAt(double position) const {
    const auto count = static_cast<double>(lengths_.size() - 1);
    if (position > count) return lengths_.back() + lengthAt(position - count);
    const auto i = std::min(static_cast<std::size_t>(position), lengths_.size() - 2);
    return lengths_[i] + (position - static_cast<double>(i)) * (lengths_[i + 1] - lengths_[i]);
}

double CoincidentRuns::length(const Run& run) const { return lengthAt(run.end) - lengthAt(run.begin); }

// The line from its start to its end, each run with what becomes of it. The start of a closed line is arbitrary: its
// last run may go on over it.
std::vector<Run> CoincidentRuns::parted() const {
    std::vector<double> changes{0.0, static_cast<double>(lengths_.size() - 1)};
    std::vector<Run> changed = typed_;
    for (const auto& [begin, end] : gone_) changed.push_back({begin, end, {}});
    for (const Run& run : changed) changes.insert(changes.end(), {run.begin, run.end});
    std::ranges::sort(changes);
    std::vector<Run> runs;
    for (std::size_t i = 0; i + 1 < changes.size(); ++i) {
        if (changes[i] == changes[i + 1]) continue;
        runs.push_back({changes[i], changes[i + 1], own_});
    }
    for (const Run& over : changed) {
        const auto first = std::ranges::lower_bound(runs, over.begin, {}, &Run::begin);
        for (auto run = first; run != runs.end() && run->begin < over.end; ++run)
            run->type = over.type ? std::optional{std::min(*run->type, *over.type)} : std::nullopt;
    }
    joinAlike(runs);
    if (closed_ && runs.size() > 1 && runs.front().type == runs.back().type) {
        runs.back().end += runs.front().end;
        runs.erase(runs.begin());
    }
    return runs;
}

// Runs on which no other line falls become as those beside them.
void CoincidentRuns::absorb(std::vector<Run>& runs, double shorterThan) const {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (runs.size() == 1 || runs[i].type != own_ || length(runs[i]) >= shorterThan) continue;
        runs[i].type = runs[i > 0 ? i - 1 : i + 1].type;
    }
    joinAlike(runs);
}

// Whether another line is beside a stretch of the line from its start to its end, but for gaps where either bends.
bool CoincidentRuns::isBeside(double from, double to) const {
    const auto isGap = [&](double end) { return lengthAt(end) - lengthAt(from) > 2.0 * within_; };
    for (const auto& [begin, end] : beside_) {
        if (end <= from) continue;
        if (begin >= to) break;
        if (begin > from && isGap(begin)) return false;
        from = end;
    }
    return from >= to || !isGap(to);
}

bool CoincidentRuns::isBeside(const Run& run) const {
    const auto count = static_cast<double>(lengths_.size() - 1);
    return run.end <= count ? isBeside(run.begin, run.end)
                            : isBeside(run.begin, count) && isBeside(0.0, run.end - count);
}

// Stretches between two that go, which are no further off than that the eye takes them for the same line, go as well.
void CoincidentRuns::absorbBeside(std::vector<Run>& runs) const {
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const bool goes = runs[i].type && length(runs[i]) < shortest_ && isBeside(runs[i]);
        if (runs.size() > 1 && goes) runs[i].type = {};
    }
    joinAlike(runs);
}

std::vector<Run> CoincidentRuns::doubtful() const {
    std::vector<Run> runs = parted();
    absorb(runs, 2.0 * within_);
    if (runs.size() == 1) return {};
    std::erase_if(runs, [&](const Run& run) { return !run.type || length(run) >= shortest_; });
    return runs;
}

std::vector<Run> CoincidentRuns::cleaned() const {
    std::vector<Run> runs = parted();
    absorb(runs, 2.0 * within_);
    if (beside_.begin() != beside_.end()) absorbBeside(runs);
    const auto isOwn = [&](const Run& run) { return run.type == own_; };
    if (std::ranges::any_of(runs, isOwn)) {
        for (Run& run : runs)
            if (length(run) < shortest_) run.type = own_;
        joinAlike(runs);
        absorb(runs, minPart);
    }
    std::erase_if(runs, [](const Run& run) { return !run.type; });
    return runs;
}

}  // namespace inkedge::lines
