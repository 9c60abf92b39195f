#include "trace/trace_lines.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "base/stop.h"
#include "raster/pair_mark.h"
#include "scene/prepared.h"

namespace inkedge {
namespace {

constexpr double minBend = 0.05;  // pixel footprints over a step: planes that bend by less do not say where they meet

// A line across the step between two neighbouring samples.
struct StepCrossing {
    glm::vec2 at;               // samples of the whole picture
    LineTypes types;            // empty: there is no line
    float inverseDepth = 0.0F;  // as StrokeSurface
    std::uint32_t triangle = 0;
};

// The crossings of one row of samples with their neighbours to the right and below.
struct CrossingRow {
    explicit CrossingRow(int width) : right(static_cast<std::size_t>(width)), down(static_cast<std::size_t>(width)) {}

    // Most samples have no crossings: only those that have are cleared.
    void clear() {
        for (const int column : columns) right[static_cast<std::size_t>(column)].types = {};
        for (const int column : columns) down[static_cast<std::size_t>(column)].types = {};
        columns.clear();
    }

    std::vector<StepCrossing> right;
    std::vector<StepCrossing> down;
    std::vector<int> columns;  // of samples with crossings, ascending
};

// Calls visit(x) where a row of marks is not 0. Most marks are 0: eight of them are skipped at a time.
template <class Visit>
void forEachMarked(const Image<std::uint8_t>& marks, int y, int begin, int end, Visit visit) {
    const std::uint8_t* const row = &marks.at(0, y);
    constexpr int step = sizeof(std::uint64_t);
    for (int x = begin; x < end;) {
        std::uint64_t next = 1;
        if (x + step <= end) std::memcpy(&next, row + x, sizeof next);
        if (next == 0) {
            x += step;
            continue;
        }
        for (const int stop = std::min(x + step, end); x < stop; ++x) {
            if (row[x] != 0) visit(x);
        }
    }
}

// The coordinates of a sample in its tile.
struct Sample {
    int x;
    int y;
};

// The kept part of a tile and the samples around it: crossings up to there count for the tile's lines and maps.
Rectangle aroundKept(const Tile& tile) {
    const auto [x, y, size] = tile.keptInDrawn();
    const int left = std::max(x - 1, 0);
    const int top = std::max(y - 1, 0);
    return {left,
            top,
            {std::min(x + size.width + 1, tile.drawn.size.width) - left,
             std::min(y + size.height + 1, tile.drawn.size.height) - top}};
}

class Tracer {
public:
    Tracer(const LineBuffers& buffers, const ScreenTriangles& triangles, const Camera& camera)
        : buffers_{buffers},
          triangles_{triangles},
          orthographic_{camera.orthographic()},
          focalLength_{camera.focalLength(buffers.tile.whole)},
          columns_{aroundKept(buffers.tile)},
          types_{buffers.marks.size, 1} {}

    void traceRow(int y, CrossingRow& crossings) {
        crossings.clear();
        forEachMarked(buffers_.marks, y, columns_.x, columns_.x + columns_.size.width, [&](int x) {
            const unsigned marks = buffers_.marks.at(x, y);
            const auto column = static_cast<std::size_t>(x);
            if ((marks & 15U) != 0) crossings.right[column] = crossing({x, y}, {x + 1, y}, marks & 15U);
            if ((marks >> 4U) != 0) crossings.down[column] = crossing({x, y}, {x, y + 1}, marks >> 4U);
            crossings.columns.push_back(x);
        });
    }

    // Maps::types at the nearer sample of each crossing traced so far.
    Image<std::uint16_t> takeTypes() { return std::move(types_); }

private:
    using End = ScreenTriangles::End;
    using Walk = ScreenTriangles::Walk;

    [[nodiscard]] bool isBackground(Sample s) const { return buffers_.triangles.at(s.x, s.y) == 0; }
    [[nodiscard]] SceneFace triangle(Sample s) const { return triangles_.locate(buffers_.triangles.at(s.x, s.y) - 1); }
    // The centre of a sample in the whole picture.
    [[nodiscard]] glm::dvec2 centre(Sample s) const {
        const Rectangle& drawn = buffers_.tile.drawn;
        return {s.x + drawn.x + 0.5, s.y + drawn.y + 0.5};
    }
    [[nodiscard]] Walk walk(Sample from, Sample to) const {
        return triangles_.walk(triangle(from), centre(from), centre(to));
    }

    // Where coplanar layers overlap a pixel holds the sum of their patches' numbers. If one side has one layer more,
    // the difference is the number of that layer.
    [[nodiscard]] std::optional<double> layerBorder(Sample from, Sample to) const {
        const float difference = buffers_.planes.at(from.x, from.y, 3) - buffers_.planes.at(to.x, to.y, 3);
        return triangles_.layerBorder(static_cast<std::uint32_t>(std::abs(difference)), centre(from), centre(to));
    }

    // The plane of a sample's triangle. Planes that were drawn are rounded differently in each tile; this one is the
    // same in all tiles.
    [[nodiscard]] ScreenTriangles::Plane plane(Sample s) const { return triangles_.plane(triangle(s), centre(s)); }

    [[nodiscard]] bool isNearer(Sample q, Sample p) const {
        constexpr double rounding = 1e-5;  // of drawn planes: a few steps of a float
        const double wp = static_cast<double>(buffers_.planes.at(p.x, p.y));
        const double wq = static_cast<double>(buffers_.planes.at(q.x, q.y));
        if (std::abs(wp - wq) > rounding * std::max(std::abs(wp), std::abs(wq))) return wq > wp;
        constexpr double equal = 1e-9;  // faces of equal depth count as equal, however numbers are rounded
        const double atP = plane(p).w;
        const double atQ = plane(q).w;
        return atQ - atP > equal * std::max(std::abs(atP), std::abs(atQ));
    }

    // Where the planes of p and q meet on the step from p to q; none if they do not, or bend too little to say.
    [[nodiscard]] std::optional<double> planesMeet(Sample p, Sample q) const {
        const ScreenTriangles::Plane atP = plane(p);
        const ScreenTriangles::Plane atQ = plane(q);
        const double rp = atQ.w - (atP.w + (p.x == q.x ? atP.dy : atP.dx));
        const double rq = atP.w - (atQ.w - (p.x == q.x ? atQ.dy : atQ.dx));
        const double footprints = orthographic_ ? focalLength_ : focalLength_ / std::max(atP.w, atQ.w);
        const double bend = std::abs(rp + rq) * footprints;
        if (rp * rq < 0.0 || !(bend > minBend) || !std::isfinite(bend)) return {};  // faces seen edge-on have no plane
        return rq / (rp + rq);
    }

    StepCrossing crossing(Sample p, Sample q, unsigned marks) {
        const bool swap = isBackground(p) || (!isBackground(q) && isNearer(q, p));
        const Sample near = swap ? q : p;
        const Sample far = swap ? p : q;
        const bool jumps = (marks & (PairMark::background | PairMark::jump)) != 0;
        const Walk way = walk(near, far);
        if ((marks & ~(PairMark::bend | PairMark::jump)) == 0 && goesOnSmoothly(way, far)) return {};

        // If the nearer surface goes on to the far sample, where it is not seen any more, it ends there, within the
        // grid that vertices snap to.
        double t = way.exit ? way.exit->t : jumps && way.arrivedAt ? 1.0 : 0.5;  // from near to far
        if (!jumps) {
            if (const std::optional<double> meet = planesMeet(p, q)) {
                t = swap ? 1.0 - *meet : *meet;
            } else if (!way.exit) {
                if (const Walk back = walk(far, near); back.exit) {
                    t = 1.0 - back.exit->t;
                } else if (const auto border = layerBorder(near, far)) {
                    t = *border;
                }
            }
        }
        const LineTypes types = classify(near, far, marks, way.exit);
        types_.at(near.x, near.y) |= static_cast<std::uint16_t>(types.bits());
        const glm::dvec2 from = centre(near);
        const glm::dvec2 to = centre(far);
        const glm::dvec2 offset = t * (to - from);
        return {glm::vec2{from + offset}, types, inverseDepthAt(near, offset), buffers_.triangles.at(near.x, near.y)};
    }

    // The inverse depth of the surface that a sample sees, extended to the line. Beyond the sample itself faces seen
    // edge-on say little of it.
    [[nodiscard]] float inverseDepthAt(Sample s, glm::dvec2 offset) const {
        constexpr double maxChange = 0.1;
        const ScreenTriangles::Plane seen = plane(s);
        const double step = seen.dx * offset.x + seen.dy * offset.y;
        return static_cast<float>(std::abs(step) <= maxChange * std::abs(seen.w) ? seen.w + step : seen.w);
    }

    // Whether one patch goes on from a sample to another, so that there is no line. Its faces may bend by more than the
    // crease angle in several smooth steps, or fall off by more than their planes say where narrow faces lie between
    // them. If the walk ends on another triangle than the one seen there, the patch runs into itself.
    [[nodiscard]] bool goesOnSmoothly(const Walk& way, Sample far) const {
        if (way.exit) return false;
        const SceneFace seen = triangle(far);
        return !way.arrivedAt || triangles_.touch({seen.instance, *way.arrivedAt}, seen);
    }

    [[nodiscard]] LineTypes classify(Sample near, Sample far, unsigned marks,
                                     const std::optional<ScreenTriangles::Exit>& exit) const {
        const bool atBorder = exit && exit->end == End::Border;
        const LineTypes boundary = atBorder ? LineTypes{LineType::Boundary} : LineTypes{};
        if ((marks & PairMark::background) != 0) return LineType::Outline | boundary;
        const bool otherObject = triangle(near).instance != triangle(far).instance;
        const LineTypes object = otherObject ? LineTypes{LineType::Object} : LineTypes{};
        if ((marks & PairMark::jump) != 0) return LineType::Occlusion | boundary | object;
        if (otherObject) return LineType::Intersection | object;
        if (exit && exit->end == End::Fold) return LineType::Occlusion;
        return exit ? LineType::Crease : LineType::Intersection;
    }

    const LineBuffers& buffers_;
    const ScreenTriangles& triangles_;
    bool orthographic_;
    double focalLength_;
    Rectangle columns_;
    Image<std::uint16_t> types_;
};

// Removes the marks of pinholes. Vertices that nearly touch leave cracks, through which single samples see what lies
// behind. A sample is a pinhole if its four neighbours share a surface in front of it that goes on from each neighbour
// to the opposite one.
class PinholeFilter {
public:
    PinholeFilter(LineBuffers& buffers, const Camera& camera, double unit)
        : buffers_{buffers},
          orthographic_{camera.orthographic()},
          focalLength_{camera.focalLength(buffers.tile.whole) * (camera.orthographic() ? unit : 1.0)} {}

    void apply() {
        const Size size = buffers_.marks.size;
        for (int y = 1; y + 1 < size.height; ++y) {
            forEachMarked(buffers_.marks, y, 1, size.width - 1, [&](int x) {
                if (!standsAlone(x, y) || !isPinhole(x, y)) return;
                buffers_.marks.at(x, y) = 0;
                buffers_.marks.at(x - 1, y) &= belowMarks;
                buffers_.marks.at(x, y - 1) &= rightMarks;
            });
        }
    }

private:
    static constexpr unsigned rightMarks = 0x0F;
    static constexpr unsigned belowMarks = 0xF0;

    [[nodiscard]] bool standsAlone(int x, int y) const {
        const unsigned own = buffers_.marks.at(x, y);
        return (own & rightMarks) != 0 && (own & belowMarks) != 0 && (buffers_.marks.at(x - 1, y) & rightMarks) != 0 &&
               (buffers_.marks.at(x, y - 1) & belowMarks) != 0;
    }

    [[nodiscard]] double plane(int x, int y, int channel) const {
        return static_cast<double>(buffers_.planes.at(x, y, channel));
    }

    // Whether the two samples beside (x, y) along an axis see one patch that goes on from one to the other in front of
    // (x, y).
    [[nodiscard]] bool coveredAlong(int x, int y, int dx, int dy) const {
        const double patch = plane(x - dx, y - dy, 3);
        if (patch == 0.0 || patch != plane(x + dx, y + dy, 3)) return false;
        const int axis = dx != 0 ? 1 : 2;
        const double before = plane(x - dx, y - dy, 0) + plane(x - dx, y - dy, axis);
        const double after = plane(x + dx, y + dy, 0) - plane(x + dx, y + dy, axis);
        const double k = orthographic_ ? focalLength_ : focalLength_ / std::max(before, after);
        const double slope = std::min(std::abs(plane(x - dx, y - dy, axis)), std::abs(plane(x + dx, y + dy, axis)));
        if (std::abs(before - after) * k > 1.0 + slope * k) return false;
        return plane(x, y, 3) == 0.0 || plane(x, y, 0) < std::min(before, after);
    }

    [[nodiscard]] bool isPinhole(int x, int y) const {
        return plane(x - 1, y, 3) == plane(x, y - 1, 3) && coveredAlong(x, y, 1, 0) && coveredAlong(x, y, 0, 1);
    }

    LineBuffers& buffers_;
    bool orthographic_;
    double focalLength_;
};

// Joins the crossings around each cell of 2 x 2 samples.
class CellJoiner {
public:
    CellJoiner(DrawnTypes types, int samplesPerPixel, TraceSurfaces surfaces, const Tile& tile, TracedLines& traced)
        : types_{types},
          scale_{1.0F / static_cast<float>(samplesPerPixel)},
          keepsSurfaces_{surfaces == TraceSurfaces::Keep},
          tile_{tile},
          traced_{traced} {}

    //        top
    //   (x, y) --- (x + 1, y)
    //  left |         | right
    //       |         |
    //        --------- bottom
    // @param y  of the whole picture
    void join(int y, const CrossingRow& above, const CrossingRow& below) {
        const Rectangle kept = tile_.keptInDrawn();
        const int end = std::min(kept.x + kept.size.width, tile_.drawn.size.width - 1);
        findCells(above.columns, below.columns);
        for (const int x : cells_) {
            if (x < kept.x || x >= end) continue;
            const auto column = static_cast<std::size_t>(x);
            const StepCrossing* sides[4]{&above.right[column], &below.right[column], &above.down[column],
                                         &above.down[column + 1]};
            const auto drawnEnd = std::remove_if(
                sides, sides + 4, [&](const StepCrossing* c) { return (c->types & types_.drawn).empty(); });
            joinCell({sides, static_cast<std::size_t>(drawnEnd - sides)}, x + tile_.drawn.x, y);
        }
    }

private:
    // Finds the cells with crossings, by their left column in the tile; -1 and the last column may be among them.
    void findCells(const std::vector<int>& above, const std::vector<int>& below) {
        upper_.clear();
        for (const int column : above) {
            if (upper_.empty() || upper_.back() < column - 1) upper_.push_back(column - 1);
            upper_.push_back(column);
        }
        cells_.clear();
        std::ranges::set_union(upper_, below, std::back_inserter(cells_));
    }

    [[nodiscard]] std::uint8_t penOf(const StepCrossing& c) const {
        const LineTypes drawn = c.types & types_.drawn;
        const LineTypes withPens = drawn & types_.withPens;
        return static_cast<std::uint8_t>(bitIndex((withPens.empty() ? drawn : withPens).first()));
    }

    void add(glm::vec2 from, glm::vec2 to, const StepCrossing& crossing, float inverseDepthTo) {
        traced_.strokes.push_back({from * scale_, to * scale_, penOf(crossing)});
        if (keepsSurfaces_) traced_.surfaces.push_back({crossing.inverseDepth, inverseDepthTo, crossing.triangle});
    }

    void joinCell(std::span<const StepCrossing*> crossings, int x, int y) {
        if (crossings.empty()) return;
        if (crossings.size() == 2 && penOf(*crossings[0]) == penOf(*crossings[1])) {
            add(toBorder(*crossings[0], *crossings[1], x, y), toBorder(*crossings[1], *crossings[0], x, y),
                *crossings[0], crossings[1]->inverseDepth);
            return;
        }
        glm::vec2 centre{0.0F};
        for (const StepCrossing* c : crossings) centre += c->at / static_cast<float>(crossings.size());
        for (const StepCrossing* c : crossings) add(c->at, centre, *c, c->inverseDepth);
    }

    // The end of a stroke, extended beyond the picture's edge if its cell is the last one before the edge.
    [[nodiscard]] glm::vec2 toBorder(const StepCrossing& end, const StepCrossing& other, int x, int y) const {
        const glm::vec2 along = end.at - other.at;
        const auto beyond = [&](float coordinate, float step, float border) {
            const float further = step != 0.0F ? (border - coordinate) / step : -1.0F;
            if (further < 0.0F) return end.at;
            // The stroke's far side leaves the picture after its centre line.
            const glm::vec2 overshoot =
                further < longestReach ? farBeyond / scale_ * glm::normalize(along) : glm::vec2{0.0F};
            return end.at + std::min(further, longestReach) * along + overshoot;
        };
        const auto width = static_cast<float>(tile_.whole.width);
        const auto height = static_cast<float>(tile_.whole.height);
        if (y == 0 && end.at.y == 0.5F) return beyond(end.at.y, along.y, 0.0F);
        if (x == 0 && end.at.x == 0.5F) return beyond(end.at.x, along.x, 0.0F);
        if (y + 2 == tile_.whole.height && end.at.y == height - 0.5F) return beyond(end.at.y, along.y, height);
        if (x + 2 == tile_.whole.width && end.at.x == width - 0.5F) return beyond(end.at.x, along.x, width);
        return end.at;
    }

    static constexpr float longestReach = 2.0F;  // of the stroke's length: lines along the edge never reach it
    static constexpr float farBeyond = 17.0F;    // pixels: half the widest stroke, and its cap's edge

    DrawnTypes types_;
    float scale_;
    bool keepsSurfaces_;
    const Tile& tile_;
    TracedLines& traced_;
    std::vector<int> upper_;  // cells that touch a crossing of the row above, ascending
    std::vector<int> cells_;  // cells that touch a crossing of either row, ascending
};

// The patch, the patch across, the node and the material of each sample.
Image<std::uint32_t> traceIds(const LineBuffers& buffers, const Scene& scene, const ScreenTriangles& triangles) {
    const Size size = buffers.marks.size;
    Image<std::uint32_t> ids{size, 4};
    const auto patchAt = [&](int x, int y) {
        const std::uint32_t number = buffers.triangles.at(x, y);
        return number == 0 ? 0U : patchOf(scene, triangles.locate(number - 1));
    };
    const Rectangle part = aroundKept(buffers.tile);
    for (int y = part.y; y < part.y + part.size.height; ++y) {
        for (int x = part.x; x < part.x + part.size.width; ++x) {
            if (const std::uint32_t number = buffers.triangles.at(x, y); number != 0) {
                const SceneFace t = triangles.locate(number - 1);
                const Instance& instance = scene.instances()[t.instance];
                const auto& materials = scene.meshes()[instance.mesh].materials;
                ids.at(x, y, 0) = patchOf(scene, t);
                ids.at(x, y, 2) = t.instance + 1;
                ids.at(x, y, 3) = materials.empty() ? 0 : materials[t.triangle];
            }
            const unsigned marks = buffers.marks.at(x, y);
            const auto across = [&](int qx, int qy) {
                ids.at(x, y, 1) = patchAt(qx, qy);
                ids.at(qx, qy, 1) = patchAt(x, y);
            };
            if ((marks & 15U) != 0) across(x + 1, y);
            if ((marks >> 4U) != 0) across(x, y + 1);
        }
    }
    return ids;
}

// The types of pixels: those of all samples of a pixel.
Image<std::uint16_t> typesOfPixels(const Image<std::uint16_t>& samples, int samplesPerPixel) {
    Image<std::uint16_t> types{{samples.size.width / samplesPerPixel, samples.size.height / samplesPerPixel}, 1};
    for (int y = 0; y < samples.size.height; ++y) {
        for (int x = 0; x < samples.size.width; ++x)
            types.at(x / samplesPerPixel, y / samplesPerPixel) |= samples.at(x, y);
    }
    return types;
}

// The ids of pixels: those of a pixel's first sample beside a line, or else of its middle sample.
Image<std::uint32_t> idsOfPixels(const TracedLines& traced, int samplesPerPixel) {
    const Size size{traced.ids.size.width / samplesPerPixel, traced.ids.size.height / samplesPerPixel};
    Image<std::uint32_t> ids{size, traced.ids.channels};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            int fromX = x * samplesPerPixel + samplesPerPixel / 2;
            int fromY = y * samplesPerPixel + samplesPerPixel / 2;
            for (int i = samplesPerPixel * samplesPerPixel - 1; i >= 0; --i) {
                const int sampleX = x * samplesPerPixel + i % samplesPerPixel;
                const int sampleY = y * samplesPerPixel + i / samplesPerPixel;
                if (traced.types.at(sampleX, sampleY) == 0 && traced.ids.at(sampleX, sampleY, 1) == 0) continue;
                fromX = sampleX;
                fromY = sampleY;
            }
            std::copy_n(&traced.ids.at(fromX, fromY), ids.channels, &ids.at(x, y));
        }
    }
    return ids;
}

}  // namespace

DrawnTypes drawnTypes(const PictureSettings& settings) {
    DrawnTypes types{settings.lines, {}};
    for (std::size_t i = 0; i < settings.pens.size(); ++i) {
        if (settings.pens[i] != PenSettings{}) types.withPens |= static_cast<LineType>(1U << i);
    }
    return types;
}

TracedLines traceLines(LineBuffers buffers, const Scene& scene, const ScreenTriangles& triangles, const Camera& camera,
                       double unit, DrawnTypes types, int samplesPerPixel, TraceIds ids, TraceSurfaces surfaces) {
    TracedLines traced;
    PinholeFilter{buffers, camera, unit}.apply();
    Tracer tracer{buffers, triangles, camera};
    const Tile& tile = buffers.tile;
    const Rectangle rows = aroundKept(tile);
    CellJoiner joiner{types, samplesPerPixel, surfaces, tile, traced};
    CrossingRow above{tile.drawn.size.width};
    CrossingRow below{tile.drawn.size.width};
    tracer.traceRow(rows.y, above);
    for (int y = rows.y + 1; y < rows.y + rows.size.height; ++y) {
        stopIfAsked();
        tracer.traceRow(y, below);
        if (const int cells = y - 1 + tile.drawn.y; cells >= tile.kept.y) joiner.join(cells, above, below);
        std::swap(above, below);
    }
    traced.types = cropped(tracer.takeTypes(), tile.keptInDrawn());
    if (ids == TraceIds::Keep) traced.ids = cropped(traceIds(buffers, scene, triangles), tile.keptInDrawn());
    if (samplesPerPixel > 1) {
        if (ids == TraceIds::Keep) traced.ids = idsOfPixels(traced, samplesPerPixel);
        traced.types = typesOfPixels(traced.types, samplesPerPixel);
    }
    return traced;
}

}  // namespace inkedge
