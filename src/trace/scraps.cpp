#include "trace/scraps.h"

#include <cstdint>
#include <unordered_set>

#include <glm/geometric.hpp>

#include "base/union_find.h"
#include "lines/specks.h"
#include "trace/cell_lists.h"

namespace inkedge::trace {
namespace {

class Scraps {
public:
    explicit Scraps(const std::vector<TracedPiece>& pieces)
        : pieces_{pieces}, sets_{static_cast<std::uint32_t>(pieces.size())} {
        ends_.reserve(pieces.size());
        for (std::uint32_t i = 0; i < pieces.size(); ++i)
            for (const glm::vec2 end : pieces[i].ends) joinAt(end, i);
        joinNearFreeEnds();
    }

    // One per piece.
    std::vector<bool> find() {
        std::vector<double> lengths(pieces_.size(), 0.0);  // by root
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            const TracedPiece& piece = pieces_[i];
            lengths[sets_.root(i)] += lines::mayBeScrap(piece.type)
                                          ? double{glm::distance(piece.ends[0], piece.ends[1])}
                                          : lines::minScrapLength;
        }
        const auto isShort = [&](std::uint32_t i) { return lengths[sets_.root(i)] < lines::minScrapLength; };
        std::unordered_set<std::uint32_t> objects;  // that have longer lines
        for (std::uint32_t i = 0; i < pieces_.size(); ++i)
            if (!isShort(i)) objects.insert(pieces_[i].face.instance);
        std::vector<bool> scraps(pieces_.size());
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            const bool tiny = pieces_[i].type == LineType::Outline && !objects.contains(pieces_[i].face.instance);
            scraps[i] = isShort(i) && !tiny;
        }
        return scraps;
    }

private:
    static constexpr double cellsPerPixel = 1.0 / lines::scrapReach;

    // Where pieces end: those that share the end to the last bit.
    struct End {
        glm::vec2 pixel;
        std::uint32_t piece;  // one of them
        int count;            // of those that have some length
    };

    void joinAt(glm::vec2 pixel, std::uint32_t piece) {
        const int count = pieces_[piece].ends[0] != pieces_[piece].ends[1] ? 1 : 0;
        const Cell cell = cellOf(pixel, cellsPerPixel);
        const bool joined = cells_.anyIn(cell, [&](std::uint32_t i) {
            End& end = ends_[i];
            if (end.pixel != pixel) return false;
            end.count += count;
            sets_.unite(end.piece, piece);
            return true;
        });
        if (joined) return;
        ends_.push_back({pixel, piece, count});
        cells_.add(cell);
    }

    void joinNearFreeEnds() {
        constexpr auto reach = static_cast<float>(lines::scrapReach);
        for (const End& end : ends_) {
            if (end.count >= 2) continue;
            cells_.anyAround(cellOf(end.pixel, cellsPerPixel), [&](std::uint32_t i) {
                if (glm::distance(end.pixel, ends_[i].pixel) <= reach) sets_.unite(end.piece, ends_[i].piece);
                return false;
            });
        }
    }

    const std::vector<TracedPiece>& pieces_;
    base::UnionFind sets_;
    std::vector<End> ends_;
    CellLists cells_;  // of the ends
};

}  // namespace

void leaveOutScraps(std::vector<TracedPiece>& pieces) {
    const std::vector<bool> scraps = Scraps{pieces}.find();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        if (!scraps[i]) pieces[kept++] = pieces[i];
    pieces.resize(kept);
}

}  // namespace inkedge::trace
