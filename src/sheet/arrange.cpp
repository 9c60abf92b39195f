#include "sheet/arrange.h"

#include <algorithm>
#include <array>
#include <map>

#include "sheet/scales.h"

namespace inkedge::sheet {
namespace {

// Columns count to the right, rows down.
struct Cell {
    int column = 0;
    int row = 0;
    friend bool operator==(const Cell&, const Cell&) = default;
};

// Of views of six sides, from the front view.
Cell cellOf(NamedView view, Projection projection) {
    const int away = projection == Projection::First ? 1 : -1;
    switch (view) {
        case NamedView::Left:
            return {away, 0};
        case NamedView::Right:
            return {-away, 0};
        case NamedView::Top:
            return {0, away};
        case NamedView::Bottom:
            return {0, -away};
        case NamedView::Back:
            return {2, 0};
        case NamedView::Front:
        case NamedView::Iso:
        case NamedView::Dimetric:
            break;
    }
    return {0, 0};
}

// The middles of strips side by side, columns or rows, from `low` to `high`: spread evenly, but no further apart than
// looks like one drawing. None: they do not fit.
std::optional<std::map<int, double>> spread(const std::map<int, double>& lengths, double low, double high, double gap) {
    constexpr double widestGap = 4.0;  // in gaps
    double rest = high - low;
    for (const auto& [strip, length] : lengths) rest -= length;
    const auto gaps = static_cast<double>(lengths.size() - 1);
    if (rest < gaps * gap) return {};
    const double between = std::clamp(rest / (gaps + 2.0), gap, widestGap * gap);
    double at = low + 0.5 * (rest - gaps * between);
    std::map<int, double> middles;
    for (const auto& [strip, length] : lengths) {
        middles[strip] = at + 0.5 * length;
        at += length + between;
    }
    return middles;
}

class Arranger {
public:
    Arranger(std::span<const ViewExtent> views, const Space& space) : views_{views}, space_{space} {}

    // The middles of views in cells; some of the last views may have none yet.
    [[nodiscard]] std::optional<std::vector<glm::dvec2>> middles(std::span<const Cell> cells, double scale) const {
        std::map<int, double> widths;
        std::map<int, double> heights;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const glm::dvec2 size = scale * views_[i].size;
            widths[cells[i].column] = std::max(widths[cells[i].column], size.x);
            heights[cells[i].row] = std::max(heights[cells[i].row], size.y);
        }
        for (const Rect& area : areas()) {
            const auto columns = spread(widths, area.low.x, area.high.x, space_.gap);
            const auto rows = spread(heights, area.low.y, area.high.y, space_.gap);
            if (!columns || !rows) continue;
            std::vector<glm::dvec2> found;
            for (const Cell& cell : cells) found.emplace_back(columns->at(cell.column), rows->at(cell.row));
            if (isFree(found, scale)) return found;
        }
        return {};
    }

    // The largest scale; 0: none.
    [[nodiscard]] double largestScale(std::span<const Cell> cells) const {
        const std::vector<double>& scales = standardScales();
        const auto fits = [&](double scale) { return middles(cells, scale).has_value(); };
        const auto found = std::ranges::find_if(scales, fits);
        return found == scales.end() ? 0.0 : *found;
    }

private:
    // The whole frame, or what is above the title block, or on its left.
    [[nodiscard]] std::array<Rect, 3> areas() const {
        const Rect all = space_.framed.grown(-0.5 * space_.gap);
        const Rect block = space_.titleBlock.grown(0.5 * space_.gap);
        return {all, Rect{all.low, {all.high.x, block.low.y}}, Rect{all.low, {block.low.x, all.high.y}}};
    }

    [[nodiscard]] bool isFree(const std::vector<glm::dvec2>& middles, double scale) const {
        const Rect block = space_.titleBlock.grown(0.5 * space_.gap);
        for (std::size_t i = 0; i < middles.size(); ++i) {
            const glm::dvec2 half = 0.5 * scale * views_[i].size;
            if (block.overlaps({middles[i] - half, middles[i] + half})) return false;
        }
        return true;
    }

    std::span<const ViewExtent> views_;
    const Space& space_;
};

// Free cells among the others and around them; those among them first.
std::vector<Cell> freeCells(std::span<const Cell> taken) {
    if (taken.empty()) return {{0, 0}};
    const auto [left, right] = std::ranges::minmax(taken, {}, &Cell::column);
    const auto [top, bottom] = std::ranges::minmax(taken, {}, &Cell::row);
    std::vector<Cell> cells;
    for (const int around : {0, 1}) {
        for (int row = top.row - around; row <= bottom.row + around; ++row) {
            for (int column = right.column + around; column >= left.column - around; --column) {
                const Cell cell{column, row};
                if (std::ranges::find(taken, cell) == taken.end() && std::ranges::find(cells, cell) == cells.end())
                    cells.push_back(cell);
            }
        }
    }
    return cells;
}

// The cells of all views: those of six sides are given, each other one takes the cell that leaves the largest scale.
std::vector<Cell> cellsOf(std::span<const ViewExtent> views, Projection projection, const Arranger& arranger) {
    std::vector<Cell> cells;
    for (const ViewExtent& view : views) {
        if (isPrincipal(view.view)) {
            cells.push_back(cellOf(view.view, projection));
            continue;
        }
        double largest = -1.0;
        std::vector<Cell> best;
        for (const Cell& cell : freeCells(cells)) {
            std::vector<Cell> tried = cells;
            tried.push_back(cell);
            const double scale = arranger.largestScale(tried);
            if (scale <= largest) continue;
            largest = scale;
            best = std::move(tried);
        }
        cells = std::move(best);
    }
    return cells;
}

}  // namespace

bool isPrincipal(NamedView view) noexcept { return view != NamedView::Iso && view != NamedView::Dimetric; }

std::optional<Arrangement> arranged(std::span<const ViewExtent> views, Projection projection, const Space& space,
                                    std::optional<double> scale) {
    std::vector<ViewExtent> ordered{views.begin(), views.end()};
    std::stable_partition(ordered.begin(), ordered.end(),
                          [](const ViewExtent& view) { return isPrincipal(view.view); });
    const Arranger arranger{ordered, space};
    const std::vector<Cell> cells = cellsOf(ordered, projection, arranger);
    Arrangement result;
    const auto isPoint = [](const ViewExtent& view) { return view.size == glm::dvec2{0.0}; };  // it fits at any scale
    const double largest = std::ranges::all_of(views, isPoint) ? 1.0 : arranger.largestScale(cells);
    result.scale = scale.value_or(largest);
    if (result.scale <= 0.0) return {};
    const auto middles = arranger.middles(cells, result.scale);
    if (!middles) return {};
    for (const ViewExtent& view : views) {
        const auto at = std::ranges::find(ordered, view.view, &ViewExtent::view);
        result.middles.push_back((*middles)[static_cast<std::size_t>(at - ordered.begin())]);
    }
    return result;
}

}  // namespace inkedge::sheet
