#include "diff/match.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <glm/geometric.hpp>

namespace inkedge::diff {
namespace {

constexpr double cosOfSameWay = 0.82;  // of 35 degrees: within it two lines run the same way

bool alike(const ComparedLine& a, const ComparedLine& b) noexcept {
    if (!a.type || !b.type) return true;  // of a picture's lines neither type nor visibility is known
    return a.type == b.type && a.visible == b.visible;
}

bool runsAlong(const Sample& a, const Sample& b) noexcept {
    const glm::dvec2 none{0.0};
    return a.along == none || b.along == none || std::abs(glm::dot(a.along, b.along)) >= cosOfSameWay;
}

// The sample of the piece of a segment on which a point lies.
std::size_t sampleAt(const SampledLines& lines, const Nearest& nearest) noexcept {
    const Segment& segment = lines.segments[nearest.segment];
    const auto piece = static_cast<std::uint32_t>(nearest.share * segment.samples);
    return segment.first + std::min(piece, segment.samples - 1);
}

Match matchOf(const SampledLines& others, const Sample& sample, const Nearest& nearest, Fate fate) noexcept {
    return {fate, others.segments[nearest.segment].line, sampleAt(others, nearest), nearest.at - sample.at};
}

// Looks within the tolerance's distance: for a line of the same kind first, then for one that is as visible.
void matchNear(Side& side, const Side& other) {
    for (std::size_t i = 0; i < side.matches.size(); ++i) {
        const Sample& sample = side.sampled.samples[i];
        const ComparedLine& line = side.lines[side.sampled.lineOf(sample)];
        std::optional<Nearest> same;
        std::optional<Nearest> asVisible;
        std::optional<Nearest> any;
        const auto keep = [](std::optional<Nearest>& best, const Nearest& found) {
            if (!best || found.squaredDistance < best->squaredDistance) best = found;
        };
        other.near.visitNear(sample.at, [&](const Nearest& found) {
            if (!runsAlong(sample, other.sampled.samples[sampleAt(other.sampled, found)])) return;
            const ComparedLine& there = other.lines[other.sampled.segments[found.segment].line];
            keep(alike(line, there) ? same : line.visible == there.visible ? asVisible : any, found);
        });
        if (same) {
            side.matches[i] = matchOf(other.sampled, sample, *same, Fate::Same);
        } else if (asVisible || any) {
            side.matches[i] = matchOf(other.sampled, sample, asVisible ? *asVisible : *any, Fate::Changed);
        }
    }
}

// A line is of another kind if that, too, has no better counterpart; else lines of two kinds ran on each other, and
// the one that is left covers what the other showed.
void keepMutualChanges(Side& side, const Side& other) {
    for (Match& match : side.matches)
        if (match.fate == Fate::Changed && other.matches[match.sample].fate == Fate::Same) match.fate = Fate::Same;
}

// For what is gone, the nearest that is gone on the other side.
std::vector<Match> nearestGone(const Side& side, const Side& other) {
    std::vector<Match> found(side.matches.size());
    for (std::size_t i = 0; i < side.matches.size(); ++i) {
        if (side.matches[i].fate != Fate::Gone) continue;
        const Sample& sample = side.sampled.samples[i];
        const ComparedLine& line = side.lines[side.sampled.lineOf(sample)];
        double best = INFINITY;
        other.around.visitNear(sample.at, [&](const Nearest& nearest) {
            const std::size_t there = sampleAt(other.sampled, nearest);
            if (nearest.squaredDistance >= best || other.matches[there].fate != Fate::Gone ||
                !runsAlong(sample, other.sampled.samples[there]) ||
                !alike(line, other.lines[other.sampled.segments[nearest.segment].line]))
                return;
            best = nearest.squaredDistance;
            found[i] = matchOf(other.sampled, sample, nearest, Fate::Moved);
        });
    }
    return found;
}

using LinePair = std::pair<std::uint32_t, std::uint32_t>;  // before, after

// What moved: samples of a pair of lines that are each other's nearest.
void takeMutual(Side& side, const std::vector<Match>& found, const std::vector<Match>& back) {
    for (std::size_t i = 0; i < found.size(); ++i) {
        const Match& match = found[i];
        if (match.fate != Fate::Moved) continue;
        const Match& opposite = back[match.sample];
        if (opposite.fate == Fate::Moved && opposite.line == side.sampled.lineOf(side.sampled.samples[i]))
            side.matches[i] = match;
    }
}

// Least squares: the way t whose part across the line, n . t, is what the nearest points say, over the samples of one
// line whose counterparts lie on another.
class MoveFit {
public:
    void add(const Sample& sample, glm::dvec2 way) {
        const glm::dvec2 n{-sample.along.y, sample.along.x};
        const double offset = glm::dot(n, way);
        const double w = sample.length;
        xx_ += w * n.x * n.x;
        xy_ += w * n.x * n.y;
        yy_ += w * n.y * n.y;
        x_ += w * offset * n.x;
        y_ += w * offset * n.y;
        squares_ += w * offset * offset;
        weight_ += w;
    }

    struct Result {
        glm::dvec2 way;
        double error;  // root of the mean square of what is left over
    };
    [[nodiscard]] Result solve() const {
        // Along the eigenvectors of the matrix; of a straight line one value is near 0, and nothing is known along it.
        const double mean = 0.5 * (xx_ + yy_);
        const double spread = std::hypot(0.5 * (xx_ - yy_), xy_);
        const double angle = 0.5 * std::atan2(2.0 * xy_, xx_ - yy_);
        const glm::dvec2 major{std::cos(angle), std::sin(angle)};
        const glm::dvec2 minor{-major.y, major.x};
        constexpr double straight = 0.02;
        const double alongMajor = (x_ * major.x + y_ * major.y) / (mean + spread);
        const bool bends = mean - spread > straight * (mean + spread);
        const double alongMinor = bends ? (x_ * minor.x + y_ * minor.y) / (mean - spread) : 0.0;
        const double explained =
            alongMajor * (x_ * major.x + y_ * major.y) + alongMinor * (x_ * minor.x + y_ * minor.y);
        return {alongMajor * major + alongMinor * minor, std::sqrt(std::max(squares_ - explained, 0.0) / weight_)};
    }

private:
    double xx_ = 0.0, xy_ = 0.0, yy_ = 0.0, x_ = 0.0, y_ = 0.0, squares_ = 0.0, weight_ = 0.0;
};

// The samples of a line whose counterparts lie on another one, those within the distance included.
template <class Visit>
void visitPair(Side& side, std::uint32_t line, std::uint32_t onto, Visit&& visit) {
    for (std::size_t i = side.sampled.firstOfLine[line]; i < side.sampled.firstOfLine[line + 1]; ++i)
        if (Match& match = side.matches[i]; match.fate != Fate::Gone && match.line == onto)
            visit(side.sampled.samples[i], match);
}

// Whether so much of a line lies across a way that the line has gone it, and not only slid along itself at its end.
bool liesAcross(Side& side, LinePair pair, glm::dvec2 way) {
    constexpr double enough = 1.0 / 3.0;
    double all = 0.0;
    double across = 0.0;
    visitPair(side, pair.first, pair.second, [&](const Sample& sample, const Match&) {
        const glm::dvec2 n{-sample.along.y, sample.along.x};
        all += sample.length;
        if (std::abs(glm::dot(n, way)) > 0.5 * glm::length(way)) across += sample.length;
    });
    return across >= enough * all;
}

LineMove moveOf(Side& before, Side& after, LinePair pair, double distance) {
    MoveFit fit;
    double farthest = 0.0;
    visitPair(before, pair.first, pair.second, [&](const Sample& sample, const Match& match) {
        fit.add(sample, match.way);
        if (match.fate == Fate::Moved) farthest = std::max(farthest, glm::length(match.way));
    });
    const auto [way, error] = fit.solve();
    const double length = glm::length(way);
    constexpr double noise = 0.25;  // pixels
    const bool explains = length > distance && error < std::max(noise, 0.15 * length);
    if (!explains || !liesAcross(before, pair, way)) return {pair.first, pair.second, farthest, {}};
    // The whole line moved, those pieces too that lie on themselves.
    const auto take = [](const Sample&, Match& match) { match.fate = Fate::Moved; };
    visitPair(before, pair.first, pair.second, take);
    visitPair(after, pair.second, pair.first, take);
    return {pair.first, pair.second, length, way};
}

}  // namespace

std::vector<LineMove> matchSides(Side& before, Side& after, double distance) {
    matchNear(before, after);
    matchNear(after, before);
    keepMutualChanges(before, after);
    keepMutualChanges(after, before);
    const std::vector<Match> forth = nearestGone(before, after);
    const std::vector<Match> back = nearestGone(after, before);
    takeMutual(before, forth, back);
    takeMutual(after, back, forth);

    std::set<LinePair> pairs;
    for (std::size_t i = 0; i < before.matches.size(); ++i)
        if (before.matches[i].fate == Fate::Moved)
            pairs.insert({before.sampled.lineOf(before.sampled.samples[i]), before.matches[i].line});
    std::vector<LineMove> moves;
    for (const LinePair& pair : pairs) moves.push_back(moveOf(before, after, pair, distance));
    return moves;
}

}  // namespace inkedge::diff
