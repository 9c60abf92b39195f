#include "lines/coincident.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/stop.h"
#include "lines/coincident_runs.h"
#include "lines/picture_grid.h"
#include "settings/pens.h"

namespace inkedge::lines {
namespace {

constexpr double asNear = 0.1;       // pixel footprints of depth: no line is nearer than the other
constexpr double shortest = 1e-3;    // pixels: shorter pieces have no direction, and shorter overlaps are none
constexpr double roundAnEnd = 10.0;  // times as far along a line as it may be off: what is as near only bends
constexpr std::uint32_t piecesBetweenLooks = 256;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// A straight piece of a line.
struct Piece {
    std::uint32_t line;
    std::uint32_t number;  // in the line
    glm::dvec2 a;
    glm::dvec2 b;
    double start;  // pixels along the line to a
    double length;
    glm::dvec2 along;  // unit
};

// Two pieces along each other. Positions along a line count pieces, as those of a Part do.
struct Overlap {
    bool isBeside;  // not as near to each other as lines that are one, but not much further
    struct Side {
        std::uint32_t line;
        double from;
        double to;  // may be less than from
        double depth;
    };
    Side stays;
    Side goes;
};

// How near another line a line is when it falls on it, and for how long at least; pixels.
struct Reach {
    double within;
    double shortest;
};

Reach reachOf(const Line& line, const std::array<settings::Pen, settings::penCount>& pens) {
    if (line.visible) return {coincidentWithin, minCoincident};
    const double width = pens[settings::penOf(line)].width;
    return {std::max(minHiddenWithin, width),
            std::max(minCoincident, (settings::dashLength + settings::gapLength) * width)};
}

class Merger {
public:
    Merger(std::vector<Line> lines, const PictureSettings& picture, const Screen& screen, glm::dvec3 origin)
        : lines_{std::move(lines)}, screen_{screen}, origin_{origin}, lengths_(lines_.size()), runs_(lines_.size()) {
        const auto pens = settings::pens(picture);
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            reaches_.push_back(reachOf(lines_[i], pens));
            if (picture.lines.contains(lines_[i].type)) addPieces(i);
        }
    }

    std::vector<Line> merge() {
        std::vector<Overlap> overlaps = findOverlaps();
        if (overlaps.empty()) return std::move(lines_);
        // The nearest first: what has gone makes no other line go.
        std::vector<std::pair<Rank, std::uint32_t>> order;
        order.reserve(overlaps.size());
        for (std::uint32_t i = 0; i < overlaps.size(); ++i) order.emplace_back(rank(overlaps[i].stays), i);
        std::ranges::stable_sort(order);
        for (const auto& each : order) settle(overlaps[each.second]);
        std::vector<Line> merged;
        for (std::uint32_t i = 0; i < lines_.size(); ++i) {
            if (!runs_[i]) {
                merged.push_back(std::move(lines_[i]));
            } else {
                for (const Run& run : runs_[i]->cleaned()) merged.push_back(cut(lines_[i], run));
            }
        }
        return merged;
    }

private:
    void addPieces(std::uint32_t i) {
        const Line& line = lines_[i];
        const std::size_t count = line.points.size() - (line.closed ? 0 : 1);
        double start = 0.0;
        for (std::uint32_t k = 0; k < count; ++k) {
            const glm::dvec2 a = line.points[k].pixel;
            const glm::dvec2 b = line.points[(k + 1) % line.points.size()].pixel;
            const double length = glm::distance(a, b);
            if (length > shortest) pieces_.push_back({i, k, a, b, start, length, (b - a) / length});
            start += length;
        }
        lengths_[i] = start;
    }

    // Whether a hidden line is too short to be cut, or to cut a longer one.
    [[nodiscard]] bool isScrap(std::uint32_t line) const {
        return !lines_[line].visible && lengths_[line] < reaches_[line].shortest;
    }

    // How near two lines are when they are one.
    [[nodiscard]] double within(std::uint32_t a, std::uint32_t b) const {
        return std::max(reaches_[a].within, reaches_[b].within);
    }

    // Of hidden lines, those beside others are found, too.
    [[nodiscard]] double farthest(std::uint32_t a, std::uint32_t b) const {
        return lines_[a].visible && lines_[b].visible ? within(a, b) : 2.0 * within(a, b);
    }

    [[nodiscard]] std::vector<Overlap> findOverlaps() const {
        double reach = 0.0;
        for (std::uint32_t i = 0; i < lines_.size(); ++i) reach = std::max(reach, farthest(i, i));
        const PictureGrid grid{screen_.size()};
        const CellLists listed{grid, pieces_.size(), [&](std::uint32_t p, auto&& visit) {
                                   grid.forEachCell(pieces_[p].a, pieces_[p].b, reach, visit);
                               }};
        std::vector<Overlap> overlaps;
        std::vector<std::uint32_t> lookedAtFor(pieces_.size(), ~0U);
        for (std::uint32_t p = 0; p < pieces_.size(); ++p) {
            if (p % piecesBetweenLooks == 0) base::stopIfAsked();
            grid.forEachCell(pieces_[p].a, pieces_[p].b, 0.0, [&](std::size_t cell) {
                for (const std::uint32_t other : listed.in(cell)) {
                    if (other >= p) break;
                    if (lookedAtFor[other] == p) continue;
                    lookedAtFor[other] = p;
                    addOverlaps(pieces_[p], pieces_[other], overlaps);
                }
            });
        }
        return overlaps;
    }

    void addOverlaps(const Piece& p, const Piece& q, std::vector<Overlap>& overlaps) const {
        const double far = farthest(p.line, q.line);
        const double apart[2]{cross(p.along, q.a - p.a), cross(p.along, q.b - p.a)};
        if (std::min(apart[0], apart[1]) > far || std::max(apart[0], apart[1]) < -far) return;
        const double one = within(p.line, q.line);
        if (const auto overlap = overlapOf(p, q, apart, one)) overlaps.push_back(*overlap);
        if (far == one) return;
        if (auto overlap = overlapOf(p, q, apart, far)) {
            overlap->isBeside = true;
            overlaps.push_back(*overlap);
        }
    }

    // The stretch of p along which q runs.
    // @param apart  how far q's ends are from p
    [[nodiscard]] std::optional<Overlap> overlapOf(const Piece& p, const Piece& q, const double (&apart)[2],
                                                   double within) const {
        if (std::min(apart[0], apart[1]) > within || std::max(apart[0], apart[1]) < -within) return {};
        const double at[2]{glm::dot(p.along, q.a - p.a), glm::dot(p.along, q.b - p.a)};
        const double whole = at[1] - at[0];
        if (std::abs(whole) <= shortest) return {};
        // Shares of q: first where it lies beside p, then where it is near enough.
        double shares[2]{(0.0 - at[0]) / whole, (p.length - at[0]) / whole};
        if (shares[0] > shares[1]) std::swap(shares[0], shares[1]);
        const double begin = std::max(0.0, shares[0]);
        const double end = std::min(1.0, shares[1]);
        double from = begin;
        double to = end;
        const double slope = apart[1] - apart[0];
        if (std::abs(slope) > 1e-12) {
            const double low = (-within - apart[0]) / slope;
            const double high = (within - apart[0]) / slope;
            from = std::max(from, std::min(low, high));
            to = std::min(to, std::max(low, high));
        }
        const double overlap = (to - from) * std::abs(whole);
        if (overlap <= shortest) return {};
        // Pieces that only cross part on either side. Many such in a row are no line that falls on another.
        const bool seen = lines_[p.line].visible && lines_[q.line].visible;
        if (seen && from > begin && to < end && overlap < minCoincident) return {};
        const auto shareOfP = [&](double share) { return std::clamp((at[0] + share * whole) / p.length, 0.0, 1.0); };
        if (p.line == q.line && bends(p, shareOfP(0.5 * (from + to)), q, 0.5 * (from + to))) return {};
        return decided(sideOf(p, shareOfP(from), shareOfP(to)), sideOf(q, from, to));
    }

    // Whether two points of one line are near each other because it has not gone on far from one to the other.
    [[nodiscard]] bool bends(const Piece& p, double atP, const Piece& q, double atQ) const {
        const double between = std::abs(p.start + atP * p.length - q.start - atQ * q.length);
        const double round = lines_[p.line].closed ? lengths_[p.line] - between : between;
        return std::min(between, round) < roundAnEnd * farthest(p.line, p.line);
    }

    [[nodiscard]] Overlap::Side sideOf(const Piece& piece, double from, double to) const {
        const double middle = piece.number + 0.5 * (from + to);
        const glm::dvec3 point = atPosition(lines_[piece.line], middle).position - origin_;
        const double depth = screen_.depth(point);
        const double footprint = screen_.footprint(point);
        // In footprints: in perspective these grow with the depth.
        const double steps = screen_.orthographic() ? depth / footprint : std::log(depth) * depth / footprint;
        return {piece.line, piece.number + from, piece.number + to, steps};
    }

    [[nodiscard]] Overlap decided(const Overlap::Side& p, const Overlap::Side& q) const {
        const auto order = [&](const Overlap::Side& side) {
            return std::tuple{lines_[side.line].type, side.line, side.from};
        };
        const bool seenAlike = lines_[p.line].visible == lines_[q.line].visible;
        bool pStays = lines_[p.line].visible;
        if (seenAlike && isScrap(p.line) != isScrap(q.line)) {
            pStays = isScrap(q.line);
        } else if (seenAlike) {
            pStays = std::abs(p.depth - q.depth) > asNear ? p.depth < q.depth : order(p) < order(q);
        }
        return pStays ? Overlap{false, p, q} : Overlap{false, q, p};
    }

    using Rank = std::tuple<bool, bool, double, LineType, std::uint32_t>;
    [[nodiscard]] Rank rank(const Overlap::Side& side) const {
        const Line& line = lines_[side.line];
        return {!line.visible, isScrap(side.line), std::floor(side.depth / asNear), line.type, side.line};
    }

    void settle(const Overlap& overlap) {
        const Line& stays = lines_[overlap.stays.line];
        const Line& goes = lines_[overlap.goes.line];
        if (runsOf(overlap.stays.line).hasGone(0.5 * (overlap.stays.from + overlap.stays.to))) return;
        if (overlap.isBeside) return runsOf(overlap.goes.line).addBeside(overlap.goes.from, overlap.goes.to);
        if (stays.visible && goes.visible && goes.type < stays.type)
            runsOf(overlap.stays.line).add(overlap.stays.from, overlap.stays.to, goes.type);
        runsOf(overlap.goes.line).add(overlap.goes.from, overlap.goes.to, {});
    }

    CoincidentRuns& runsOf(std::uint32_t line) {
        if (!runs_[line]) runs_[line].emplace(lines_[line], reaches_[line].within, reaches_[line].shortest);
        return *runs_[line];
    }

    // A position along a line, in space.
    struct PositionOnLine {
        const LinePoint& p;
        const LinePoint& q;
        double share;  // of the way from p to q in the picture
        double inSpace;
        glm::dvec3 position;
    };
    [[nodiscard]] PositionOnLine atPosition(const Line& line, double position) const {
        const std::size_t count = line.points.size();
        const auto piece = static_cast<std::size_t>(position);
        const LinePoint& p = line.points[piece % count];
        const double share = position - static_cast<double>(piece);
        if (share == 0.0) return {p, p, 0.0, 0.0, p.position};
        const LinePoint& q = line.points[(piece + 1) % count];
        const auto inverseDepth = [&](const LinePoint& point) {
            return screen_.project(point.position - origin_).inverseDepth;
        };
        const double inSpace =
            screen_.orthographic() ? share : screen_.unproject(share, inverseDepth(p), inverseDepth(q));
        return {p, q, share, inSpace, p.position + inSpace * (q.position - p.position)};
    }

    [[nodiscard]] LinePoint pointAt(const Line& line, double position) const {
        const auto [p, q, share, inSpace, at] = atPosition(line, position);
        if (share == 0.0) return p;
        return {p.pixel + share * (q.pixel - p.pixel), at, p.strength + inSpace * (q.strength - p.strength)};
    }

    // A run may go on over the start of a closed line.
    [[nodiscard]] Line cut(const Line& line, const Run& run) const {
        if (line.closed && run.end - run.begin >= static_cast<double>(line.points.size())) {
            Line whole = line;
            whole.type = *run.type;
            return whole;
        }
        Line part{*run.type, line.visible, false, line.id, line.object, line.patch, {}, line.width};
        part.points.push_back(pointAt(line, run.begin));
        for (double joint = std::floor(run.begin) + 1.0; joint < run.end; ++joint)
            part.points.push_back(pointAt(line, joint));
        part.points.push_back(pointAt(line, run.end));
        return part;
    }

    std::vector<Line> lines_;
    const Screen& screen_;
    glm::dvec3 origin_;
    std::vector<Reach> reaches_;  // one per line
    std::vector<Piece> pieces_;
    std::vector<double> lengths_;                      // of lines, pixels
    std::vector<std::optional<CoincidentRuns>> runs_;  // one per line; none: it stays as it is
};

}  // namespace

std::vector<Line> mergeCoincident(std::vector<Line> lines, const PictureSettings& picture, const Screen& screen,
                                  glm::dvec3 origin) {
    return Merger{std::move(lines), picture, screen, origin}.merge();
}

}  // namespace inkedge::lines
