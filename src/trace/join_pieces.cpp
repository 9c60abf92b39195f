#include "trace/join_pieces.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_set>
#include <utility>

#include <glm/geometric.hpp>

#include "lines/bridge_gaps.h"
#include "lines/chains.h"
#include "lines/segment.h"
#include "scene/prepared.h"

namespace inkedge::trace {
namespace {

using lines::Chain;
using lines::Key;
using lines::Screen;
using lines::ScreenSegment;
using lines::Segment;

constexpr double minLength = 2.0;  // pixels

Key pixelKey(glm::vec2 pixel) {
    return (Key{std::bit_cast<std::uint32_t>(pixel.x)} << 32U) | std::bit_cast<std::uint32_t>(pixel.y);
}

class PieceJoiner {
public:
    PieceJoiner(std::span<const TracedPiece> pieces, const Scene& scene, const Screen& screen)
        : pieces_{pieces}, scene_{scene}, screen_{screen} {
        segments_.reserve(pieces.size());
        projected_.reserve(pieces.size());
        for (const TracedPiece& piece : pieces) {
            Segment& segment = segments_.emplace_back();
            ScreenSegment& projected = projected_.emplace_back();
            for (std::size_t k = 0; k < 2; ++k) {
                segment.keys[k] = pixelKey(piece.ends[k]);
                projected.ends[k] = {glm::dvec2{piece.ends[k]}, double{piece.inverseDepths[k]}};
                projected.world[k] = screen.worldAt(projected.ends[k]);
            }
        }
    }

    std::vector<Line> join() {
        for (const Chain& chain : lines::chainSegments(segments_, projected_)) addChain(chain);
        dropStubs();
        return lines::bridgeGaps(std::move(lines_), screen_, scene_.bounds().centre);
    }

private:
    // Links of a chain whose pieces are of one type, node and width.
    struct Run {
        std::size_t begin;
        std::size_t end;
        double length;             // pixels
        const TracedPiece* piece;  // says which type and node
        double width;              // their mean
    };

    [[nodiscard]] static bool isOfLine(const Run& a, const Run& b) {
        return a.piece->type == b.piece->type && a.piece->face.instance == b.piece->face.instance;
    }

    [[nodiscard]] static bool goOn(const Run& a, const Run& b) {
        constexpr double sameWidth = 0.1;  // of the pen's
        return isOfLine(a, b) && std::abs(a.width - b.width) <= sameWidth;
    }

    // Under what length a run belongs to the longer one beside it. Strips taper off where lines meet at a sharp angle:
    // the ends of lines there are of other widths.
    [[nodiscard]] static double shortestAmong(const std::vector<Run>& runs, const Run& run) {
        constexpr double minTaper = 8.0;  // pixels
        const std::size_t i = static_cast<std::size_t>(&run - runs.data());
        const bool tapers =
            (i > 0 && isOfLine(runs[i - 1], run)) || (i + 1 < runs.size() && isOfLine(runs[i + 1], run));
        return tapers ? minTaper : minLength;
    }

    // A run, and the one that follows it.
    [[nodiscard]] static Run joined(const Run& a, const Run& b) {
        const double length = a.length + b.length;
        const double share = length > 0.0 ? b.length / length : 0.0;
        return {a.begin, b.end, length, a.piece, a.width + share * (b.width - a.width)};
    }

    // The runs of a chain. What is under minLength belongs to the longer run beside it: near junctions samples differ
    // in what they see.
    [[nodiscard]] std::vector<Run> runsOf(const Chain& chain) const {
        std::vector<Run> runs;
        for (std::size_t i = 0; i < chain.links.size(); ++i) {
            const TracedPiece& piece = pieces_[chain.links[i].segment];
            const Run run{i, i + 1, double{glm::distance(piece.ends[0], piece.ends[1])}, &piece, double{piece.width}};
            if (runs.empty() || !goOn(runs.back(), run)) {
                runs.push_back(run);
            } else {
                runs.back() = joined(runs.back(), run);
            }
        }
        for (;;) {
            const auto isShort = [&](const Run& run) { return run.length < shortestAmong(runs, run); };
            const auto shortest = std::ranges::min_element(runs, {}, [&](const Run& run) {
                return std::pair{!isShort(run), run.length};
            });
            if (runs.size() == 1 || !isShort(*shortest)) return runs;
            const auto after = shortest + 1;
            const bool first = shortest == runs.begin();
            const auto rank = [&](const Run& run) { return std::pair{isOfLine(run, *shortest), run.length}; };
            const bool joinsAfter = first || (after != runs.end() && rank(*after) > rank(*(shortest - 1)));
            const auto longer = joinsAfter ? after : shortest - 1;
            *longer = {std::min(longer->begin, shortest->begin), std::max(longer->end, shortest->end),
                       longer->length + shortest->length, longer->piece, longer->width};
            const auto next = runs.erase(shortest);
            if (next == runs.begin() || next == runs.end() || !goOn(*(next - 1), *next)) continue;
            *next = joined(*(next - 1), *next);
            runs.erase(next - 1);
        }
    }

    void addChain(const Chain& chain) {
        const std::vector<Run> runs = runsOf(chain);
        for (const Run& run : runs) {
            begin(chain.links[run.begin], run);
            for (std::size_t i = run.begin; i < run.end; ++i) addEnd(chain.links[i], 1);
        }
        if (chain.closed && runs.size() == 1) {
            lines_.back().closed = true;
            lines_.back().points.pop_back();
        }
    }

    // Leaves out lines under minLength that begin or end on a longer one: corners of three lines, of which each cell of
    // samples sees another two.
    void dropStubs() {
        const auto isShort = [](const Line& line) {
            double length = 0.0;
            for (std::size_t i = 1; i < line.points.size(); ++i)
                length += glm::distance(line.points[i - 1].pixel, line.points[i].pixel);
            return !line.closed && length < minLength;
        };
        std::unordered_set<Key> onLonger;
        for (const Line& line : lines_) {
            if (isShort(line)) continue;
            for (const LinePoint& point : line.points) onLonger.insert(pixelKey(glm::vec2{point.pixel}));
        }
        std::erase_if(lines_, [&](const Line& line) {
            const auto touches = [&](const LinePoint& p) { return onLonger.contains(pixelKey(glm::vec2{p.pixel})); };
            return isShort(line) && (touches(line.points.front()) || touches(line.points.back()));
        });
    }

    void begin(Chain::Link link, const Run& run) {
        Line& line = lines_.emplace_back();
        line.type = run.piece->type;
        line.object = run.piece->face.instance + 1;
        line.patch = scene::patchOf(scene_, run.piece->face);
        line.width = run.width;
        addEnd(link, 0);
    }

    void addEnd(Chain::Link link, std::size_t end) {
        const ScreenSegment& s = projected_[link.segment];
        const std::size_t k = link.reversed ? 1 - end : end;
        lines_.back().points.push_back({s.ends[k].pixel, s.world[k] + scene_.bounds().centre});
    }

    std::span<const TracedPiece> pieces_;
    const Scene& scene_;
    const Screen& screen_;
    std::vector<Segment> segments_;
    std::vector<ScreenSegment> projected_;
    std::vector<Line> lines_;
};

}  // namespace

std::vector<Line> joinPieces(std::span<const TracedPiece> pieces, const Scene& scene, const Screen& screen) {
    return PieceJoiner{pieces, scene, screen}.join();
}

}  // namespace inkedge::trace
