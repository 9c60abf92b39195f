#include "trace/join_pieces.h"

#include <array>
#include <bit>

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
        return lines::bridgeGaps(std::move(lines_), screen_, scene_.bounds().centre);
    }

private:
    [[nodiscard]] bool goOn(const TracedPiece& a, const TracedPiece& b) const {
        return a.type == b.type && a.face.instance == b.face.instance;
    }

    void addChain(const Chain& chain) {
        const std::size_t first = lines_.size();
        for (std::size_t i = 0; i < chain.links.size(); ++i) {
            const Chain::Link link = chain.links[i];
            const TracedPiece& piece = pieces_[link.segment];
            if (i == 0 || !goOn(piece, pieces_[chain.links[i - 1].segment])) begin(link, piece);
            addEnd(link, 1);
        }
        if (chain.closed && lines_.size() == first + 1) {
            lines_.back().closed = true;
            lines_.back().points.pop_back();
        }
    }

    void begin(Chain::Link link, const TracedPiece& piece) {
        Line& line = lines_.emplace_back();
        line.type = piece.type;
        line.object = piece.face.instance + 1;
        line.patch = scene::patchOf(scene_, piece.face);
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
