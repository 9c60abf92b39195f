#include "diff/changes.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "diff/join_ends.h"

namespace inkedge::diff {
namespace {

// What a run of samples has in common.
struct Kind {
    Fate fate = Fate::Same;
    std::uint32_t onto = 0;        // of what moved: the line of the other side
    std::optional<LineType> type;  // of what changed: as it is there
    bool visible = true;
    friend bool operator==(const Kind&, const Kind&) = default;
};

// Samples that follow each other on a line, of one kind.
struct Run {
    Kind kind;
    std::size_t first;
    std::size_t count;
    double length;
};

Kind kindOf(const Match& match, const Side& other) {
    switch (match.fate) {
        case Fate::Moved:
            return {match.fate, match.line, {}, true};
        case Fate::Changed:
            return {match.fate, 0, other.lines[match.line].type, other.lines[match.line].visible};
        case Fate::Same:
        case Fate::Gone:
            break;
    }
    return {match.fate, 0, {}, true};
}

// Joins neighbours of one kind; of a closed line the last and the first are left as two.
void joinNeighbours(std::vector<Run>& runs) {
    std::vector<Run> joined;
    for (const Run& run : runs) {
        if (joined.empty() || joined.back().kind != run.kind) {
            joined.push_back(run);
        } else {
            joined.back().count += run.count;
            joined.back().length += run.length;
        }
    }
    runs = std::move(joined);
}

// The runs of a line. What is as short as `shortest` between two runs of one kind becomes of their kind: where another
// line crosses, or comes near, it covers a few samples of a line that is gone.
std::vector<Run> runsOf(const Side& side, const Side& other, std::size_t line, double shortest) {
    std::vector<Run> runs;
    for (std::size_t i = side.sampled.firstOfLine[line]; i < side.sampled.firstOfLine[line + 1]; ++i)
        runs.push_back({kindOf(side.matches[i], other), i, 1, side.sampled.samples[i].length});
    joinNeighbours(runs);
    const std::size_t count = runs.size();
    const bool closed = side.lines[line].closed && count > 2;
    for (std::size_t i = 0; i < count; ++i) {
        if (!closed && (i == 0 || i + 1 == count)) continue;
        const Kind& around = runs[(i + count - 1) % count].kind;
        if (runs[i].length <= shortest && around == runs[(i + 1) % count].kind) runs[i].kind = around;
    }
    joinNeighbours(runs);
    return runs;
}

// The polyline of a run: the ends of its pieces, and the corners between them.
ComparedLine lineOf(const Side& side, std::size_t line, const Run& run) {
    ComparedLine part = side.lines[line];
    const std::size_t all = side.sampled.firstOfLine[line + 1] - side.sampled.firstOfLine[line];
    if (run.count == all) return part;
    part.closed = false;
    part.points.clear();
    const std::vector<Sample>& samples = side.sampled.samples;
    const std::vector<Segment>& segments = side.sampled.segments;
    const auto alongOf = [&](const Sample& sample) {  // half its piece
        const Segment& segment = segments[sample.segment];
        return 0.5 / segment.samples * (segment.b - segment.a);
    };
    part.points.push_back(samples[run.first].at - alongOf(samples[run.first]));
    for (std::size_t i = run.first + 1; i < run.first + run.count; ++i)
        if (samples[i].segment != samples[i - 1].segment) part.points.push_back(segments[samples[i].segment].a);
    const Sample& last = samples[run.first + run.count - 1];
    part.points.push_back(last.at + alongOf(last));
    return part;
}

double totalLength(const std::vector<ComparedLine>& lines) {
    double length = 0.0;
    for (const ComparedLine& line : lines) length += lengthOf(line);
    return length;
}

double drawnLength(const Side& side, HiddenChanges hidden) {
    double length = 0.0;
    for (const Sample& sample : side.sampled.samples)
        if (hidden == HiddenChanges::Count || side.lines[side.sampled.lineOf(sample)].visible) length += sample.length;
    return length;
}

bool isHidden(const std::vector<ComparedLine>& lines) {
    return std::ranges::none_of(lines, [](const ComparedLine& line) { return line.visible; });
}

// The runs of one side, sorted by what becomes of them.
struct Parts {
    std::vector<ComparedLine> same;
    std::vector<ComparedLine> gone;
    /// By type and visibility on the other side.
    std::map<std::pair<std::optional<LineType>, bool>, std::vector<ComparedLine>> changed;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<ComparedLine>> moved;  // by line here and there
};

Parts partsOf(const Side& side, const Side& other, double shortest) {
    Parts parts;
    for (std::uint32_t line = 0; line < side.lines.size(); ++line) {
        for (const Run& run : runsOf(side, other, line, shortest)) {
            ComparedLine part = lineOf(side, line, run);
            switch (run.kind.fate) {
                case Fate::Same:
                    parts.same.push_back(std::move(part));
                    break;
                case Fate::Gone:
                    parts.gone.push_back(std::move(part));
                    break;
                case Fate::Changed:
                    parts.changed[{run.kind.type, run.kind.visible}].push_back(std::move(part));
                    break;
                case Fate::Moved:
                    parts.moved[{line, run.kind.onto}].push_back(std::move(part));
                    break;
            }
        }
    }
    return parts;
}

void add(LinesComparison& comparison, LineChange change) {
    const bool hidden = isHidden(change.before) && isHidden(change.after);
    if (hidden && comparison.tolerance.hidden == HiddenChanges::Ignore) return;
    const ComparedLine& line = change.after.empty() ? change.before.front() : change.after.front();
    change.type = line.type;
    change.visible = line.visible;
    change.object = line.object;
    change.length = std::max(totalLength(change.before), totalLength(change.after));
    if (change.length < comparison.tolerance.speck) {
        ++comparison.specks;
        comparison.speckLength += change.length;
    } else {
        comparison.changes.push_back(std::move(change));
    }
}

}  // namespace

void collectChanges(const Side& before, const Side& after, const std::vector<LineMove>& moves,
                    LinesComparison& comparison) {
    const double shortest = 2.0 * comparison.tolerance.distance;
    Parts old = partsOf(before, after, shortest);
    Parts now = partsOf(after, before, shortest);
    const HiddenChanges hidden = comparison.tolerance.hidden;
    comparison.lengthBefore = drawnLength(before, hidden);
    comparison.lengthAfter = drawnLength(after, hidden);
    comparison.unchanged = std::move(now.same);
    if (hidden == HiddenChanges::Ignore)
        std::erase_if(comparison.unchanged, [](const ComparedLine& line) { return !line.visible; });

    for (ComparedLine& line : joinEnds(std::move(old.gone), shortest))
        add(comparison, {.kind = LineChangeKind::Vanished, .before = {std::move(line)}});
    for (ComparedLine& line : joinEnds(std::move(now.gone), shortest))
        add(comparison, {.kind = LineChangeKind::Appeared, .after = {std::move(line)}});
    for (auto& [was, lines] : now.changed) {
        const auto& [type, visible] = was;
        for (ComparedLine& line : joinEnds(std::move(lines), shortest)) {
            LineChange change{.kind = line.visible == visible ? LineChangeKind::Retyped : LineChangeKind::Visibility,
                              .typeBefore = type,
                              .visibleBefore = visible,
                              .after = {std::move(line)}};
            change.before = change.after;
            change.before.front().type = type;
            change.before.front().visible = visible;
            add(comparison, std::move(change));
        }
    }
    for (const LineMove& move : moves) {
        LineChange change{.kind = LineChangeKind::Moved, .distance = move.distance, .way = move.way};
        change.before = std::move(old.moved[{move.before, move.after}]);
        change.after = std::move(now.moved[{move.after, move.before}]);
        if (!change.before.empty() || !change.after.empty()) add(comparison, std::move(change));
    }
}

}  // namespace inkedge::diff
