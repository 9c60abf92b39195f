#include "mesh/cut_out.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/message.h"
#include "mesh/clip_polygon.h"
#include "mesh/polygon_triangles.h"
#include "mesh/simplify_loop.h"
#include "mesh/twice_area.h"

namespace inkedge::mesh {
namespace {

constexpr int cellSize = CutOut::cellSize;
constexpr double simplification = 0.1;  // texels
constexpr std::int64_t maxCellsOfTriangle = 4096;
constexpr std::uint64_t maxPieces = 4'000'000;
constexpr double maxSteps = 8192.0;                           // along an edge whose factor changes
constexpr std::uint64_t maxSamples = std::uint64_t{1} << 26;  // where factors change

// ---- the outline within a cell

// Texel coordinates: whole numbers at the centres of texels.
class Opacity {
public:
    Opacity(std::shared_ptr<const Image<std::uint8_t>> map, std::array<TextureWrap, 2> wrap)
        : whole_{std::move(map)}, map_{*whole_}, wrap_{wrap} {}

    [[nodiscard]] double at(std::int64_t x, std::int64_t y) const {
        return map_(wrapped(x, map_.size().width, wrap_[0]), wrapped(y, map_.size().height, wrap_[1]));
    }
    [[nodiscard]] glm::dvec2 texels(glm::dvec2 coordinates) const {
        return coordinates * glm::dvec2{map_.size().width, map_.size().height} - 0.5;
    }

    // Between the centres of texels.
    [[nodiscard]] double between(glm::dvec2 texels) const {
        const glm::dvec2 low = glm::floor(texels);
        const glm::dvec2 share = texels - low;
        const int left = wrapped(static_cast<std::int64_t>(low.x), map_.size().width, wrap_[0]);
        const int right = wrapped(static_cast<std::int64_t>(low.x) + 1, map_.size().width, wrap_[0]);
        const auto inRow = [&](std::int64_t y) {
            const int row = wrapped(y, map_.size().height, wrap_[1]);
            return glm::mix<double>(map_(left, row), map_(right, row), share.x);
        };
        const auto y = static_cast<std::int64_t>(low.y);
        return glm::mix(inRow(y), inRow(y + 1), share.y);
    }

private:
    static int wrapped(std::int64_t i, int size, TextureWrap wrap) {
        if (i >= 0 && i < size) return static_cast<int>(i);
        if (wrap == TextureWrap::Clamp) return static_cast<int>(std::clamp<std::int64_t>(i, 0, size - 1));
        const std::int64_t period = wrap == TextureWrap::Mirror ? 2 * std::int64_t{size} : size;
        const std::int64_t rest = ((i % period) + period) % period;
        return static_cast<int>(rest < size ? rest : period - 1 - rest);
    }

    std::shared_ptr<const Image<std::uint8_t>> whole_;
    const Image<std::uint8_t>& map_;
    std::array<TextureWrap, 2> wrap_;
};

// The opaque parts of a cell, as loops anticlockwise around them (x to the right, y up), holes clockwise.
class CellOutline {
public:
    CellOutline(const Opacity& opacity, std::int64_t cellX, std::int64_t cellY, double threshold)
        : threshold_{threshold} {
        for (int y = 0; y <= cellSize; ++y)
            for (int x = 0; x <= cellSize; ++x)
                values_[at(x, y)] = opacity.at(cellX * cellSize + x, cellY * cellSize + y);
    }

    [[nodiscard]] bool whole() const {
        return std::ranges::all_of(values_, [&](double v) { return v >= threshold_; });
    }
    [[nodiscard]] bool nothing() const {
        return std::ranges::none_of(values_, [&](double v) { return v >= threshold_; });
    }

    [[nodiscard]] std::vector<Polygon> trace() {
        for (int y = 0; y < cellSize; ++y)
            for (int x = 0; x < cellSize; ++x) traceSquare(x, y);
        traceBorder();
        return takeLoops();
    }

private:
    // A corner of the outline: a grid point, or the crossing of the grid's edge from it to the right or upwards.
    enum Kind { Point, Right, Up };
    static int key(int x, int y, Kind kind) { return 3 * static_cast<int>(at(x, y)) + kind; }
    static constexpr std::size_t at(int x, int y) {
        return static_cast<std::size_t>(y) * (cellSize + 1) + static_cast<std::size_t>(x);
    }
    [[nodiscard]] bool inside(int x, int y) const { return values_[at(x, y)] >= threshold_; }

    [[nodiscard]] glm::dvec2 pointOf(int corner) const {
        const int gridPoint = corner / 3;
        const int x = gridPoint % (cellSize + 1);
        const int y = gridPoint / (cellSize + 1);
        glm::dvec2 point{x, y};
        const auto kind = static_cast<Kind>(corner % 3);
        if (kind == Point) return point;
        const double a = values_[at(x, y)];
        const double b = kind == Right ? values_[at(x + 1, y)] : values_[at(x, y + 1)];
        point[kind == Right ? 0 : 1] += (threshold_ - a) / (b - a);
        return point;
    }

    void link(int from, int to) { next_.emplace(from, to); }

    // Marching squares; the inside lies to the left.
    void traceSquare(int x, int y) {
        const int bottom = key(x, y, Right);
        const int top = key(x, y + 1, Right);
        const int left = key(x, y, Up);
        const int right = key(x + 1, y, Up);
        const int corners = inside(x, y) | inside(x + 1, y) << 1 | inside(x + 1, y + 1) << 2 | inside(x, y + 1) << 3;
        switch (corners) {
            case 1:
                return link(bottom, left);
            case 2:
                return link(right, bottom);
            case 3:
                return link(right, left);
            case 4:
                return link(top, right);
            case 6:
                return link(top, bottom);
            case 7:
                return link(top, left);
            case 8:
                return link(left, top);
            case 9:
                return link(bottom, top);
            case 11:
                return link(right, top);
            case 12:
                return link(left, right);
            case 13:
                return link(bottom, right);
            case 14:
                return link(left, bottom);
            case 5:
            case 10:
                return traceSaddle(x, y, corners == 5);
            default:
                return;
        }
    }

    void traceSaddle(int x, int y, bool risingInside) {
        const int bottom = key(x, y, Right);
        const int top = key(x, y + 1, Right);
        const int left = key(x, y, Up);
        const int right = key(x + 1, y, Up);
        const double centre =
            0.25 * (values_[at(x, y)] + values_[at(x + 1, y)] + values_[at(x, y + 1)] + values_[at(x + 1, y + 1)]);
        const bool joined = centre >= threshold_;
        if (risingInside) {
            link(bottom, joined ? right : left);
            link(top, joined ? left : right);
        } else {
            link(right, joined ? top : bottom);
            link(left, joined ? bottom : top);
        }
    }

    // Along the cell's border, anticlockwise.
    void traceBorder() {
        const auto side = [&](auto pointAt, auto crossingAt) {
            for (int i = 0; i < cellSize; ++i) {
                const auto [ax, ay] = pointAt(i);
                const auto [bx, by] = pointAt(i + 1);
                const int a = key(ax, ay, Point);
                const int b = key(bx, by, Point);
                const bool aInside = inside(ax, ay);
                const bool bInside = inside(bx, by);
                if (aInside && bInside) link(a, b);
                if (aInside && !bInside) link(a, crossingAt(i));
                if (!aInside && bInside) link(crossingAt(i), b);
            }
        };
        using P = std::pair<int, int>;
        side([](int i) { return P{i, 0}; }, [](int i) { return key(i, 0, Right); });
        side([](int i) { return P{cellSize, i}; }, [](int i) { return key(cellSize, i, Up); });
        side(
            [](int i) {
                return P{cellSize - i, cellSize};
            },
            [](int i) { return key(cellSize - i - 1, cellSize, Right); });
        side([](int i) { return P{0, cellSize - i}; }, [](int i) { return key(0, cellSize - i - 1, Up); });
    }

    [[nodiscard]] std::vector<Polygon> takeLoops() {
        std::vector<Polygon> loops;
        while (!next_.empty()) {
            Polygon loop;
            std::vector<bool> fixed;
            for (auto link = next_.begin(); link != next_.end(); link = next_.find(takeNext(link))) {
                loop.push_back(pointOf(link->first));
                fixed.push_back(isFixed(link->first, loop.back()));
            }
            loops.push_back(simplified(loop, fixed, simplification));
        }
        return loops;
    }

    int takeNext(std::unordered_map<int, int>::iterator link) {
        const int to = link->second;
        next_.erase(link);
        return to;
    }

    // A corner where the outline crosses the cell's border stays: the cell beyond has the same corner.
    static bool isFixed(int corner, glm::dvec2 point) {
        const auto onBorder = [](double x) { return x == 0.0 || x == cellSize; };
        if (corner % 3 != Point) return onBorder(point.x) || onBorder(point.y);
        return onBorder(point.x) && onBorder(point.y);
    }

    double threshold_;
    std::array<double, (cellSize + 1) * (cellSize + 1)> values_{};
    std::unordered_map<int, int> next_;  // corner -> the next along the outline
};

// A convex polygon's part in the cell, whose corners are (0, 0) and (cellSize, cellSize).
Polygon withinCell(const Polygon& polygon) { return withinBox(polygon, glm::dvec2{0.0}, glm::dvec2{cellSize}); }

}  // namespace

struct CutOut::State {
    struct Cell {
        bool whole = false;
        std::vector<Polygon> outline;  // empty: nothing is opaque, unless whole
    };

    const Cell& cell(std::int64_t x, std::int64_t y) {
        const auto known = cells.find({x, y});
        if (known != cells.end()) return known->second;
        if (cellsLeft == 0)
            base::refuse(fmt::format("expected cut-outs that span at most {} x {} x {} texels, found more",
                                     CutOut::maxCells, cellSize, cellSize));
        --cellsLeft;
        CellOutline outline{opacity, x, y, threshold};
        Cell made{outline.whole(), {}};
        if (!made.whole && !outline.nothing()) made.outline = untangled(outline.trace());
        return cells.emplace(std::pair{x, y}, std::move(made)).first->second;
    }

    [[nodiscard]] bool isOpaque(glm::dvec2 texels) const {
        const glm::dvec2 nearest = glm::round(texels);
        return opacity.at(static_cast<std::int64_t>(nearest.x), static_cast<std::int64_t>(nearest.y)) >= threshold;
    }

    [[nodiscard]] std::array<glm::dvec2, 3> texelsOf(const std::array<glm::dvec2, 3>& corners) const {
        constexpr double farthest = 1e9;  // texels
        std::array<glm::dvec2, 3> texels;
        for (std::size_t i = 0; i < 3; ++i) {
            texels[i] = opacity.texels(corners[i]);
            if (!(std::abs(texels[i].x) < farthest && std::abs(texels[i].y) < farthest))
                base::refuse(fmt::format("expected texture coordinates near the picture, found ({}, {})", corners[i].x,
                                         corners[i].y));
        }
        return texels;
    }

    void spend(const std::vector<TrianglePiece>& made) {
        pieces += made.size();
        if (pieces > maxPieces)
            base::refuse(fmt::format("expected a cut-out of at most {} triangles, found more", maxPieces));
    }

    Opacity opacity;
    double threshold;
    std::map<std::pair<std::int64_t, std::int64_t>, Cell> cells;
    std::uint64_t& cellsLeft;
    std::uint64_t pieces = 0;
    std::uint64_t samples = 0;
};

CutOut::CutOut(std::shared_ptr<const Image<std::uint8_t>> opacity, std::array<TextureWrap, 2> wrap, double threshold,
               std::uint64_t& cellsLeft)
    : state_{std::make_unique<State>(State{Opacity{std::move(opacity), wrap}, threshold, {}, cellsLeft, 0, 0})} {}
CutOut::~CutOut() = default;

std::vector<TrianglePiece> CutOut::cut(const std::array<glm::dvec2, 3>& corners) {
    const std::array<glm::dvec2, 3> inTexels = state_->texelsOf(corners);
    const double area = twiceArea(inTexels[0], inTexels[1], inTexels[2]);
    constexpr double thinnest = 1e-4;  // square texels
    if (std::abs(area) < thinnest) {
        if (!state_->isOpaque((inTexels[0] + inTexels[1] + inTexels[2]) / 3.0)) return {};
        return {TrianglePiece{glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}}};
    }
    const auto cellOf = [](double texels) { return static_cast<std::int64_t>(std::floor(texels / cellSize)); };
    const glm::dvec2 low = glm::min(glm::min(inTexels[0], inTexels[1]), inTexels[2]);
    const glm::dvec2 high = glm::max(glm::max(inTexels[0], inTexels[1]), inTexels[2]);
    const std::int64_t columns = cellOf(high.x) - cellOf(low.x) + 1;
    const std::int64_t rows = cellOf(high.y) - cellOf(low.y) + 1;
    if (columns > maxCellsOfTriangle || rows > maxCellsOfTriangle || columns * rows > maxCellsOfTriangle)
        base::refuse("expected triangles that repeat the picture less often, found one across too many texels");

    std::vector<TrianglePiece> pieces;
    for (std::int64_t y = cellOf(low.y); y <= cellOf(high.y); ++y) {
        for (std::int64_t x = cellOf(low.x); x <= cellOf(high.x); ++x) {
            const glm::dvec2 origin{static_cast<double>(x * cellSize), static_cast<double>(y * cellSize)};
            const State::Cell& cell = state_->cell(x, y);
            if (!cell.whole && cell.outline.empty()) continue;
            const Polygon part = withinCell({inTexels[0] - origin, inTexels[1] - origin, inTexels[2] - origin});
            if (part.size() < 3) continue;
            const auto weights = [&](const glm::dvec2& point) {
                const glm::dvec2 p = point + origin;
                const glm::dvec2 w{twiceArea(p, inTexels[1], inTexels[2]) / area,
                                   twiceArea(inTexels[0], p, inTexels[2]) / area};
                return glm::clamp(glm::dvec3{w, 1.0 - w.x - w.y}, 0.0, 1.0);
            };
            const std::vector<PolygonTriangle> triangles =
                cell.whole ? convexTriangles(part) : trianglesWithin(part, beside(part, cell.outline));
            for (const PolygonTriangle& t : triangles) {
                TrianglePiece piece{weights(t[0]), weights(t[1]), weights(t[2])};
                if (area < 0.0) std::swap(piece[1], piece[2]);
                pieces.push_back(piece);
            }
        }
    }
    state_->spend(pieces);
    return pieces;
}

std::vector<TrianglePiece> CutOut::cut(const std::array<glm::dvec2, 3>& corners, const glm::dvec3& factors) {
    const std::array<glm::dvec2, 3> texels = state_->texelsOf(corners);
    EdgeSteps steps{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double length = glm::distance(texels[k], texels[(k + 1) % 3]);
        if (length > maxSteps)
            base::refuse(
                fmt::format("expected edges of at most {} texels where vertex colors change the opacity, found {:.0f}",
                            maxSteps, length));
        steps[k] = std::bit_ceil(static_cast<std::uint32_t>(std::ceil(length)));
    }
    const std::uint64_t largest = std::max({steps[0], steps[1], steps[2]});
    state_->samples += largest * largest / 2;
    if (state_->samples > maxSamples)
        base::refuse(
            "expected triangles that span fewer texels where vertex colors change the opacity, found too many");
    const auto excess = [&](const glm::dvec3& w) {
        const glm::dvec2 at = w.x * texels[0] + w.y * texels[1] + w.z * texels[2];
        return state_->opacity.between(at) * glm::dot(w, factors) - state_->threshold;
    };
    std::vector<TrianglePiece> pieces = opaquePart(steps, excess);
    state_->spend(pieces);
    return pieces;
}

}  // namespace inkedge::mesh
