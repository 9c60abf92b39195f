#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/image.h>

namespace inkedge::lines {

/// Square cells over a picture. What lies beyond its edges belongs to the cells there.
class PictureGrid {
public:
    /// @param cellSize  pixels
    explicit PictureGrid(Size size, double cellSize = usualCell)
        : cellSize_{cellSize},
          columns_{static_cast<int>(std::ceil(size.width / cellSize))},
          rows_{static_cast<int>(std::ceil(size.height / cellSize))} {}

    static constexpr double usualCell = 8.0;

    /// Calls visit(cell) for each cell that a straight piece touches, and perhaps for a few cells beside it.
    /// @param reach  pixels: cells that are as near to the piece as that count, too
    template <class Visit>
    void forEachCell(glm::dvec2 from, glm::dvec2 to, double reach, Visit&& visit) const {
        const glm::dvec2 a = from / cellSize_;
        const glm::dvec2 b = to / cellSize_;
        const double wider = reach / cellSize_;
        const int firstRow = clampTo(rows_, std::min(a.y, b.y) - wider);
        const int lastRow = clampTo(rows_, std::max(a.y, b.y) + wider);
        for (int row = firstRow; row <= lastRow; ++row) {
            double low = std::min(a.x, b.x);
            double high = std::max(a.x, b.x);
            if (firstRow != lastRow && a.y != b.y) {  // the part of the piece between the row's borders
                const auto at = [&](double y) {
                    return a.x + (b.x - a.x) * std::clamp((y - a.y) / (b.y - a.y), 0.0, 1.0);
                };
                const double top = at(row == firstRow ? std::min(a.y, b.y) : row - wider);
                const double bottom = at(row == lastRow ? std::max(a.y, b.y) : row + 1 + wider);
                low = std::min(top, bottom);
                high = std::max(top, bottom);
            }
            const int last = clampTo(columns_, high + wider);
            for (int column = clampTo(columns_, low - wider); column <= last; ++column) visit(cellAt(column, row));
        }
    }

    [[nodiscard]] std::size_t cellOf(glm::dvec2 pixel) const {
        return cellAt(clampTo(columns_, pixel.x / cellSize_), clampTo(rows_, pixel.y / cellSize_));
    }

    [[nodiscard]] std::size_t cells() const { return cellAt(0, rows_); }

private:
    [[nodiscard]] static int clampTo(int count, double at) {
        return std::clamp(static_cast<int>(std::clamp(std::floor(at), -1.0, 1e9)), 0, count - 1);
    }
    [[nodiscard]] std::size_t cellAt(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    double cellSize_;
    int columns_;
    int rows_;
};

/// Which of a number of things lie in each cell of a grid, in their order.
class CellLists {
public:
    /// @param cellsOf  called as cellsOf(i, visit) for each thing i, twice: calls visit(cell) for each of its cells
    template <class CellsOf>
    CellLists(const PictureGrid& grid, std::size_t count, CellsOf&& cellsOf) : begins_(grid.cells() + 1, 0) {
        for (std::uint32_t i = 0; i < count; ++i) cellsOf(i, [&](std::size_t cell) { ++begins_[cell + 1]; });
        for (std::size_t cell = 0; cell < grid.cells(); ++cell) begins_[cell + 1] += begins_[cell];
        listed_.resize(begins_.back());
        std::vector<std::uint32_t> fill(begins_.begin(), begins_.end() - 1);
        for (std::uint32_t i = 0; i < count; ++i) cellsOf(i, [&](std::size_t cell) { listed_[fill[cell]++] = i; });
    }

    [[nodiscard]] std::span<const std::uint32_t> in(std::size_t cell) const {
        return std::span{listed_}.subspan(begins_[cell], begins_[cell + 1] - begins_[cell]);
    }

private:
    std::vector<std::uint32_t> begins_;  // of each cell's list; one more than cells
    std::vector<std::uint32_t> listed_;
};

}  // namespace inkedge::lines
