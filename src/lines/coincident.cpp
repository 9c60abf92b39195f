#include "lines/coincident.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/coincident_pieces.h"
#include "lines/coincident_runs.h"
#include "settings/pens.h"

namespace inkedge::lines {
namespace {

constexpr double asNear = 0.1;       // pixel footprints of depth: no line is nearer than the other
constexpr double shortest = 1e-3;    // pixels: shorter pieces have no direction, and shorter overlaps are none
constexpr double roundAnEnd = 10.0;  // times as far along a line as it may be off: what is as near only bends
// Pieces that are compared with others at once, and those of them by one thread.
constexpr std::size_t piecesAtOnce = 2048;
constexpr std::size_t piecesOfThread = 128;

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

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
        std::ranges::sort(pieces_, {}, [](const Piece& piece) { return std::pair{piece.rank, piece.index}; });
        compared_.resize(pieces_.size(), 0);
        gone_.resize(pieces_.size(), 0);
        for (const Line& line : lines_) pieceAt_.emplace_back(line.points.size(), noPiece);
        for (std::uint32_t p = 0; p < pieces_.size(); ++p) pieceAt_[pieces_[p].line][pieces_[p].number] = p;
    }

    std::vector<Line> merge() {
        double reach = 0.0;
        for (const Piece& piece : pieces_) reach = std::max(reach, farthest(piece, piece));
        const Neighbours near{screen_.size(), cellSize(), pieces_, reach};
        settleAll(near);
        Neighbours::Found found{near};
        for (std::uint32_t i = 0; i < lines_.size(); ++i)
            if (runs_[i] && !lines_[i].visible) addBeside(i, near, found);
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
        std::size_t first = pieces_.size();
        double start = 0.0;
        for (std::uint32_t k = 0; k < count; ++k) {
            const glm::dvec2 a = line.points[k].pixel;
            const glm::dvec2 b = line.points[(k + 1) % line.points.size()].pixel;
            const double length = glm::distance(a, b);
            if (length > shortest)
                pieces_.push_back({i,
                                   k,
                                   a,
                                   b,
                                   start,
                                   length,
                                   (b - a) / length,
                                   reaches_[i].within,
                                   line.visible,
                                   static_cast<std::uint32_t>(pieces_.size()),
                                   {}});
            start += length;
        }
        lengths_[i] = start;
        for (; first < pieces_.size(); ++first) pieces_[first].rank = firstRank(pieces_[first]);
    }

    // Whether a hidden line is too short to be cut, or to cut a longer one.
    [[nodiscard]] bool isScrap(std::uint32_t line) const {
        return !lines_[line].visible && lengths_[line] < reaches_[line].shortest;
    }

    // How near two lines are when they are one.
    [[nodiscard]] static double within(const Piece& p, const Piece& q) { return std::max(p.within, q.within); }

    // Of hidden lines, those beside others are found, too.
    [[nodiscard]] static double farthest(const Piece& p, const Piece& q) {
        return p.visible && q.visible ? within(p, q) : 2.0 * within(p, q);
    }

    // The nearest first: what has gone makes no other line go. A piece that has gone by its turn need not be compared
    // with those behind it, so of many lines along each other all are compared with the first ones only.
    void settleAll(const Neighbours& near) {
        for (std::size_t begin = 0; begin < pieces_.size(); begin += piecesAtOnce)
            batches_.push_back({pieces_[begin].rank, std::uint64_t{pieces_[begin].index} << 32U, 0});
        waiting_.resize(batches_.size());
        for (std::size_t begin = 0; begin < pieces_.size(); begin += piecesAtOnce) {
            const std::size_t end = std::min(pieces_.size(), begin + piecesAtOnce);
            for (std::size_t p = begin; p < end; ++p) compared_[p] = gone_[p] == 0 ? 1 : 0;
            std::vector<std::vector<Overlap>> parts((end - begin + piecesOfThread - 1) / piecesOfThread);
            base::onEach(parts.size(), [&](std::size_t part) {
                const std::size_t first = begin + part * piecesOfThread;
                Neighbours::Found found{near};
                for (std::size_t p = first; p < std::min(end, first + piecesOfThread); ++p)
                    if (compared_[p] != 0) compare(static_cast<std::uint32_t>(p), near, found, parts[part]);
            });
            for (const std::vector<Overlap>& part : parts)
                for (const Overlap& overlap : part) wait(overlap, begin / piecesAtOnce);
            settle(waiting_[begin / piecesAtOnce]);
        }
    }

    // Adds the overlaps of a piece with those that were not compared with it before.
    void compare(std::uint32_t p, const Neighbours& near, Neighbours::Found& found, std::vector<Overlap>& to) const {
        const auto isOpen = [&](std::uint32_t other) {
            if (other == p || (other < p && compared_[other] != 0)) return false;
            return gone_[other] == 0 || givesType(other, p);
        };
        near.find(p, isOpen, found);
        for (const std::uint32_t other : found.pieces())
            if (const auto overlap = overlapOf(p, other, within(pieces_[p], pieces_[other]))) to.push_back(*overlap);
    }

    // Finds the lines beside runs of a hidden one that are too short to stay otherwise.
    void addBeside(std::uint32_t line, const Neighbours& near, Neighbours::Found& found) {
        std::vector<std::uint32_t> doubtful;
        const auto count = static_cast<std::uint32_t>(pieceAt_[line].size());
        for (const Run& run : runs_[line]->doubtful())
            for (auto k = static_cast<std::uint32_t>(run.begin); k < run.end; ++k)
                if (pieceAt_[line][k % count] != noPiece) doubtful.push_back(pieceAt_[line][k % count]);
        std::ranges::sort(doubtful);  // a long piece may have many such runs
        doubtful.erase(std::unique(doubtful.begin(), doubtful.end()), doubtful.end());
        for (const std::uint32_t p : doubtful) addBesidePiece(p, near, found);
    }

    void addBesidePiece(std::uint32_t p, const Neighbours& near, Neighbours::Found& found) {
        near.find(
            p, [&](std::uint32_t i) { return i != p && gone_[i] == 0; }, found);
        for (const std::uint32_t other : found.pieces()) {
            const auto overlap = overlapOf(p, other, farthest(pieces_[p], pieces_[other]));
            if (!overlap || overlap->goes.piece != p || hasGone(overlap->stays)) continue;
            runs_[pieces_[p].line]->addBeside(overlap->goes.from, overlap->goes.to);
        }
    }

    // @param batch  now: rounding may put an overlap before it
    void wait(const Overlap& overlap, std::size_t batch) {
        const std::uint64_t stays = pieces_[overlap.stays.piece].index;
        const Waiting waiting{overlap.rank, stays << 32U | pieces_[overlap.goes.piece].index, overlaps_.size()};
        const auto after = std::ranges::upper_bound(batches_, waiting);
        waiting_[std::max(batch + 1, static_cast<std::size_t>(after - batches_.begin())) - 1].push_back(waiting);
        overlaps_.push_back(overlap);
    }

    // Pieces of later batches have no overlap that comes before these.
    void settle(std::vector<Waiting>& waiting) {
        std::ranges::sort(waiting);
        for (const Waiting& each : waiting) settle(overlaps_[each.index]);
        waiting = {};
    }

    // As many cells as pieces, at most: pixels.
    [[nodiscard]] double cellSize() const {
        const double pixels = static_cast<double>(screen_.size().width) * screen_.size().height;
        return std::clamp(std::sqrt(pixels / static_cast<double>(pieces_.size() + 1)), 1.0, 6.0);
    }

    // The stretch of one piece along which another runs.
    [[nodiscard]] std::optional<Overlap> overlapOf(std::uint32_t i, std::uint32_t j, double within) const {
        if (pieces_[i].index < pieces_[j].index) std::swap(i, j);
        const Piece& p = pieces_[i];
        const Piece& q = pieces_[j];
        const double apart[2]{cross(p.along, q.a - p.a), cross(p.along, q.b - p.a)};
        if (std::min(apart[0], apart[1]) > within || std::max(apart[0], apart[1]) < -within) return {};
        const double at[2]{glm::dot(p.along, q.a - p.a), glm::dot(p.along, q.b - p.a)};
        if (std::min(at[0], at[1]) >= p.length || std::max(at[0], at[1]) <= 0.0) return {};
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
        const double shortestRun = std::max(reaches_[p.line].shortest, reaches_[q.line].shortest);
        if (from > begin && to < end && overlap < shortestRun) return {};
        const auto shareOfP = [&](double share) { return std::clamp((at[0] + share * whole) / p.length, 0.0, 1.0); };
        if (p.line == q.line && bends(p, shareOfP(0.5 * (from + to)), q, 0.5 * (from + to))) return {};
        return decided(sideOf(i, shareOfP(from), shareOfP(to)), sideOf(j, from, to));
    }

    // Whether two points of one line are near each other because it has not gone on far from one to the other.
    [[nodiscard]] bool bends(const Piece& p, double atP, const Piece& q, double atQ) const {
        const double between = std::abs(p.start + atP * p.length - q.start - atQ * q.length);
        const double round = lines_[p.line].closed ? lengths_[p.line] - between : between;
        return std::min(between, round) < roundAnEnd * farthest(p, p);
    }

    [[nodiscard]] Overlap::Side sideOf(std::uint32_t p, double from, double to) const {
        return {p, pieces_[p].number + from, pieces_[p].number + to};
    }

    // In the middle of a side.
    [[nodiscard]] double stepsTo(const Overlap::Side& side) const {
        return stepsTo(atPosition(lines_[pieces_[side.piece].line], 0.5 * (side.from + side.to)).position);
    }

    // The depth of a point in footprints: in perspective these grow with the depth.
    [[nodiscard]] double stepsTo(glm::dvec3 position) const {
        const double depth = screen_.depth(position - origin_);
        const double footprint = screen_.footprint(position - origin_);
        return screen_.orthographic() ? depth / footprint : std::log(depth) * depth / footprint;
    }

    [[nodiscard]] Overlap decided(const Overlap::Side& p, const Overlap::Side& q) const {
        const std::uint32_t lineOfP = pieces_[p.piece].line;
        const std::uint32_t lineOfQ = pieces_[q.piece].line;
        const bool seenAlike = lines_[lineOfP].visible == lines_[lineOfQ].visible;
        bool pStays = lines_[lineOfP].visible;
        if (seenAlike && isScrap(lineOfP) != isScrap(lineOfQ)) {
            pStays = isScrap(lineOfQ);
        } else if (seenAlike) {
            const double behind = stepsTo(p) - stepsTo(q);
            const auto order = [&](std::uint32_t line, double from) {
                return std::tuple{lines_[line].type, line, from};
            };
            pStays = std::abs(behind) > asNear ? behind < 0.0 : order(lineOfP, p.from) < order(lineOfQ, q.from);
        }
        return pStays ? Overlap{rank(lineOfP, stepsTo(p)), p, q} : Overlap{rank(lineOfQ, stepsTo(q)), q, p};
    }

    [[nodiscard]] Rank rank(std::uint32_t line, double depth) const {
        constexpr int typeBits = 5;
        constexpr int depthBits = 57;
        static_assert(lineTypeCount <= 1 << typeBits);
        constexpr double limit = std::uint64_t{1} << (depthBits - 1);
        const double step = std::fmax(-limit, std::fmin(std::floor(depth / asNear), limit - 16.0));
        const auto steps =
            static_cast<std::uint64_t>(static_cast<std::int64_t>(step) + static_cast<std::int64_t>(limit));
        const std::uint64_t kind = (lines_[line].visible ? 0U : 2U) | (isScrap(line) ? 1U : 0U);
        return {((kind << depthBits | steps) << typeBits) | static_cast<std::uint64_t>(lines_[line].type), line};
    }
    [[nodiscard]] Rank firstRank(const Piece& piece) const {
        const auto& points = lines_[piece.line].points;
        const std::size_t next = (piece.number + 1) % points.size();
        return rank(piece.line, std::min(stepsTo(points[piece.number].position), stepsTo(points[next].position)));
    }

    void settle(const Overlap& overlap) {
        if (gone_[overlap.goes.piece] != 0 && !givesType(overlap.goes.piece, overlap.stays.piece)) return;
        const std::uint32_t lineOfStays = pieces_[overlap.stays.piece].line;
        const Piece& goes = pieces_[overlap.goes.piece];
        if (hasGone(overlap.stays)) return;
        CoincidentRuns& runs = runsOf(goes.line);
        if (givesType(overlap.goes.piece, overlap.stays.piece))
            runsOf(lineOfStays).add(overlap.stays.from, overlap.stays.to, lines_[goes.line].type);
        runs.add(overlap.goes.from, overlap.goes.to, {});
        if (runs.hasGone(goes.number, goes.number + 1.0, shortest / goes.length)) gone_[overlap.goes.piece] = 1;
    }

    // Whether a piece that stays becomes of the type of one that goes.
    [[nodiscard]] bool givesType(std::uint32_t goes, std::uint32_t stays) const {
        const Line& from = lines_[pieces_[goes].line];
        const Line& to = lines_[pieces_[stays].line];
        return from.visible && to.visible && from.type < to.type;
    }

    // In the middle of it.
    [[nodiscard]] bool hasGone(const Overlap::Side& side) const {
        const auto& runs = runs_[pieces_[side.piece].line];
        return runs && runs->hasGone(0.5 * (side.from + side.to));
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
    std::vector<Piece> pieces_;   // in the order of their ranks
    static constexpr std::uint32_t noPiece = ~0U;
    std::vector<std::vector<std::uint32_t>> pieceAt_;  // by line and number
    std::vector<std::uint8_t> compared_;               // one per piece: whether it was compared with all others
    std::vector<std::uint8_t> gone_;                   // one per piece: whether all of it has
    std::vector<Overlap> overlaps_;
    std::vector<Waiting> batches_;                     // where each batch of pieces begins
    std::vector<std::vector<Waiting>> waiting_;        // one per batch: the overlaps that are settled after it
    std::vector<double> lengths_;                      // of lines, pixels
    std::vector<std::optional<CoincidentRuns>> runs_;  // one per line; none: it stays as it is
};

}  // namespace

std::vector<Line> mergeCoincident(std::vector<Line> lines, const PictureSettings& picture, const Screen& screen,
                                  glm::dvec3 origin) {
    return Merger{std::move(lines), picture, screen, origin}.merge();
}

}  // namespace inkedge::lines
