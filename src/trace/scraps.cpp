#include "trace/scraps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>

#include <glm/geometric.hpp>

#include "base/union_find.h"
#include "lines/specks.h"

namespace inkedge::trace {
namespace {

constexpr auto reach = static_cast<float>(lines::scrapReach);

// One end of a piece.
struct End {
    std::uint64_t key;
    std::uint32_t piece;
    glm::vec2 pixel;
};

std::uint64_t keyOf(glm::vec2 pixel) {
    return (std::uint64_t{std::bit_cast<std::uint32_t>(pixel.x)} << 32U) | std::bit_cast<std::uint32_t>(pixel.y);
}

// Of squares as wide as the reach.
std::uint64_t cellKey(glm::vec2 pixel, int dx, int dy) {
    const auto at = [](float v, int d) {
        return static_cast<std::uint32_t>(static_cast<int>(std::floor(v / reach)) + d);
    };
    return (std::uint64_t{at(pixel.x, dx)} << 32U) | at(pixel.y, dy);
}

class Scraps {
public:
    explicit Scraps(const std::vector<TracedPiece>& pieces)
        : pieces_{pieces}, sets_{static_cast<std::uint32_t>(pieces.size())} {
        ends_.reserve(2 * pieces.size());
        for (std::uint32_t i = 0; i < pieces.size(); ++i)
            for (const glm::vec2 end : pieces[i].ends) ends_.push_back({keyOf(end), i, end});
        joinAtEnds();
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
        std::set<std::uint32_t> objects;  // that have longer lines
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
    void joinAtEnds() {
        std::ranges::sort(ends_, {}, &End::key);
        for (std::size_t i = 0; i < ends_.size();) {
            std::size_t next = i;
            int count = 0;  // of pieces of some length
            for (; next < ends_.size() && ends_[next].key == ends_[i].key; ++next) {
                const TracedPiece& piece = pieces_[ends_[next].piece];
                if (piece.ends[0] != piece.ends[1]) ++count;
                sets_.unite(ends_[i].piece, ends_[next].piece);
            }
            if (count < 2) free_.push_back(ends_[i]);
            i = next;
        }
    }

    void joinNearFreeEnds() {
        for (End& end : ends_) end.key = cellKey(end.pixel, 0, 0);
        std::ranges::sort(ends_, {}, &End::key);
        for (const End& end : free_) {
            for (int dx = -1; dx <= 1; ++dx) {
                for (int dy = -1; dy <= 1; ++dy) {
                    const std::uint64_t cell = cellKey(end.pixel, dx, dy);
                    auto other = std::ranges::lower_bound(ends_, cell, {}, &End::key);
                    for (; other != ends_.end() && other->key == cell; ++other)
                        if (glm::distance(end.pixel, other->pixel) <= reach) sets_.unite(end.piece, other->piece);
                }
            }
        }
    }

    const std::vector<TracedPiece>& pieces_;
    base::UnionFind sets_;
    std::vector<End> ends_;
    std::vector<End> free_;
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
