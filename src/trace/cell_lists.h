#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>

namespace inkedge::trace {

/// A square cell of the picture, counted from the top left one.
struct Cell {
    int x;
    int y;
    friend bool operator==(const Cell&, const Cell&) = default;
};

/// The cell that a point lies in. @param perSide  1 / the side of a cell
[[nodiscard]] inline Cell cellOf(glm::dvec2 point, double perSide) {
    const auto below = [](double v) {  // std::floor() is a call without SSE 4.1
        const int i = static_cast<int>(v);
        return v < i ? i - 1 : i;
    };
    return {below(point.x * perSide), below(point.y * perSide)};
}

/// Points by the cell that they lie in, so that those near another one are found. They are numbered from 0 as they are
/// added. Cells are found by hash: memory grows with the points alone.
class CellLists {
public:
    void add(Cell cell) {
        cells_.push_back(cell);
        next_.push_back(none);
        if (cells_.size() > buckets_.size()) {
            rebuild();
        } else {
            append(static_cast<std::uint32_t>(cells_.size() - 1));
        }
    }

    /// Calls visit(number) for the points in a cell, in the order of their numbers, until it returns true.
    /// @return  whether it did
    template <class Visit>
    bool anyIn(Cell cell, Visit visit) const {
        for (std::uint32_t i = buckets_[bucketOf(cell)].first; i != none; i = next_[i])
            if (cells_[i] == cell && visit(i)) return true;
        return false;
    }

    /// The same for the cell and the eight around it, in rows from the top.
    template <class Visit>
    bool anyAround(Cell cell, Visit visit) const {
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x)
                if (anyIn({cell.x + x, cell.y + y}, visit)) return true;
        return false;
    }

private:
    static constexpr std::uint32_t none = ~0U;
    struct Bucket {
        std::uint32_t first = none;
        std::uint32_t last = none;
    };

    // Cells of a row lie beside each other. The number of buckets is a power of two.
    [[nodiscard]] std::size_t bucketOf(Cell c) const {
        constexpr std::size_t rowStep = 0x9E3779B9U;  // odd, and far from multiples of powers of two
        return (static_cast<std::size_t>(c.x) + static_cast<std::size_t>(c.y) * rowStep) & (buckets_.size() - 1);
    }

    void append(std::uint32_t i) {
        Bucket& bucket = buckets_[bucketOf(cells_[i])];
        (bucket.first == none ? bucket.first : next_[bucket.last]) = i;
        bucket.last = i;
    }

    void rebuild() {
        buckets_.assign(4 * buckets_.size(), {});
        next_.assign(next_.size(), none);
        for (std::uint32_t i = 0; i < cells_.size(); ++i) append(i);
    }

    std::vector<Cell> cells_;          // one per point
    std::vector<std::uint32_t> next_;  // one per point: the next of its bucket
    std::vector<Bucket> buckets_{1024};
};

}  // namespace inkedge::trace
