#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/image.h>

#include "lines/picture_grid.h"

namespace inkedge::lines {

/// In the order of what stays: seen or hidden, of any length or a scrap, depth, type and line.
struct Rank {
    std::uint64_t upper;
    std::uint32_t line;
    auto operator<=>(const Rank&) const = default;
};

/// A straight piece of a line.
struct Piece {
    std::uint32_t line;
    std::uint32_t number;  ///< in the line
    glm::dvec2 a;
    glm::dvec2 b;
    double start;  ///< pixels along the line to a
    double length;
    glm::dvec2 along;  ///< unit
    double within;     ///< Reach::within of the line
    bool visible;
    std::uint32_t index;  ///< along all lines
    Rank rank;            ///< the first that an overlap in which the piece stays may have
};

/// Two pieces along each other. Positions along a line count pieces, as those of a Part do.
struct Overlap {
    Rank rank;
    struct Side {
        std::uint32_t piece;
        double from;
        double to;  ///< may be less than from
    };
    Side stays;
    Side goes;
};

/// An overlap in its turn.
struct Waiting {
    Rank rank;
    std::uint64_t pieces;  ///< the index of the one that stays in the upper half
    std::size_t index;     ///< into overlaps_
    auto operator<=>(const Waiting&) const = default;
};

/// The pieces in each cell of a grid.
class Neighbours {
public:
    Neighbours(Size size, double cellSize, std::span<const Piece> pieces, double reach)
        : pieces_{pieces}, grid_{size, cellSize}, listed_{grid_, pieces.size(), [&](std::uint32_t p, auto&& visit) {
                                                              grid_.forEachCell(pieces[p].a, pieces[p].b, reach, visit);
                                                          }} {}

    /// What one thread finds, in memory that it uses again.
    class Found {
    public:
        explicit Found(const Neighbours& of) : marked_(of.pieces_.size(), false) {}
        [[nodiscard]] std::span<const std::uint32_t> pieces() const { return pieces_; }

    private:
        friend Neighbours;
        std::vector<std::uint32_t> pieces_;
        std::vector<bool> marked_;  // one per piece: whether it is found; all false between two searches
    };

    /// Finds those that may be near a piece and are wanted, each once.
    template <class Wanted>
    void find(std::uint32_t p, Wanted&& isWanted, Found& found) const {
        found.pieces_.clear();
        grid_.forEachCell(pieces_[p].a, pieces_[p].b, 0.0, [&](std::size_t cell) {
            for (const std::uint32_t other : listed_.in(cell)) {
                if (found.marked_[other] || !isWanted(other)) continue;
                found.marked_[other] = true;
                found.pieces_.push_back(other);
            }
        });
        for (const std::uint32_t other : found.pieces_) found.marked_[other] = false;
    }

private:
    std::span<const Piece> pieces_;
    PictureGrid grid_;
    CellLists listed_;
};

}  // namespace inkedge::lines
