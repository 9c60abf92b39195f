#include "scene/coplanar_layers.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <utility>

#include <glm/common.hpp>
#include <glm/ext/vector_uint3.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "base/parallel.h"
#include "mesh/topology.h"
#include "scene/world_triangles.h"

namespace inkedge::scene {
namespace {

constexpr double planeTolerance = 2e-6;   // of the scene's radius: float coordinates are no finer
constexpr double normalStep = 1.0 / 256;  // the width of the cells that normals are sorted into
constexpr double normalTolerance = 1e-4;  // a normal is also sorted into each cell that is this near

constexpr std::uint64_t maximumSteps = 300'000'000;  // about two seconds

// Consecutive triangles of one instance with one patch number, whose normals lie in the same cells and whose planes lie
// within the tolerance of each other. A flat face of a solid consists of few runs.
struct Run {
    std::uint32_t cell;  // of normals, numbered over a cube
    float low;
    float high;  // distances of the planes from the scene's centre, in radii
    std::uint32_t instance;
    std::uint32_t first;
    std::uint32_t count;
};

// One of two opposite normals, which belong to one plane. The largest component decides, so that noise does not.
glm::dvec3 canonical(glm::dvec3 n) {
    const glm::dvec3 size = glm::abs(n);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return n[axis] < 0.0 ? -n : n;
}

// The cells that a normal lies in or is near to: usually one, seldom two to eight.
struct Cells {
    glm::uvec3 low{0U};
    glm::uvec3 high{0U};
    friend bool operator==(const Cells&, const Cells&) = default;
};

Cells cellsOf(glm::dvec3 n) {
    const auto at = [](glm::dvec3 v) { return glm::uvec3{v / normalStep + 512.0}; };
    return {at(n - normalTolerance), at(n + normalTolerance)};
}

template <class Visit>
void forEachCell(const Cells& cells, Visit visit) {
    for (std::uint32_t x = cells.low.x; x <= cells.high.x; ++x)
        for (std::uint32_t y = cells.low.y; y <= cells.high.y; ++y)
            for (std::uint32_t z = cells.low.z; z <= cells.high.z; ++z) visit((x * 1024 + y) * 1024 + z);
}

struct Plane {
    glm::dvec3 normal;  // canonical
    float distance;     // in radii
};

std::optional<Plane> planeOf(const std::array<glm::dvec3, 3>& triangle, double radius) {
    const auto& [a, b, c] = triangle;
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const double length = glm::length(area);
    if (length == 0.0) return {};
    const glm::dvec3 n = canonical(area / length);
    return Plane{n, static_cast<float>(glm::dot(n, a) / radius)};
}

// Cells of space, each with the patch that it holds triangles of. Nearly all triangles of a large surface lie in cells
// that hold no other patch, and so overlap none.
class PatchCells {
public:
    explicit PatchCells(double radius) : scale_{0.5 * side / radius}, patches_(std::size_t{side} * side * side, none) {}

    // The range of cells that a triangle's box lies in.
    struct Range {
        glm::uvec3 low;
        glm::uvec3 high;
        [[nodiscard]] std::uint32_t count() const {
            const glm::uvec3 sides = high - low + 1U;
            return sides.x * sides.y * sides.z;
        }
        [[nodiscard]] Range with(const Range& other) const {
            return {glm::min(low, other.low), glm::max(high, other.high)};
        }
    };
    [[nodiscard]] Range rangeOf(const std::array<glm::dvec3, 3>& triangle) const {
        const auto cell = [&](glm::dvec3 p) {
            return glm::uvec3{glm::clamp(p * scale_ + 0.5 * side, 0.0, side - 1.0)};
        };
        const auto& [a, b, c] = triangle;
        return {cell(glm::min(glm::min(a, b), c)), cell(glm::max(glm::max(a, b), c))};
    }

    // May be called by several threads.
    void add(const Range& range, std::uint32_t number) {
        forEach(range, [&](std::size_t cell) {
            const std::atomic_ref<std::uint32_t> patch{patches_[cell]};
            std::uint32_t found = patch.load(std::memory_order_relaxed);
            if (found == number || found == several) return;
            if (found == none && patch.compare_exchange_strong(found, number, std::memory_order_relaxed)) return;
            if (found != number) patch.store(several, std::memory_order_relaxed);
        });
    }

    [[nodiscard]] bool holdOther(const Range& range, std::uint32_t number) const {
        bool other = false;
        forEach(range, [&](std::size_t cell) { other = other || patches_[cell] != number; });
        return other;
    }

private:
    static constexpr std::uint32_t side = 96;
    static constexpr std::uint32_t none = 0;  // numbers of patches begin with 1
    static constexpr std::uint32_t several = ~0U;

    template <class Visit>
    static void forEach(const Range& range, Visit visit) {
        for (std::uint32_t z = range.low.z; z <= range.high.z; ++z)
            for (std::uint32_t y = range.low.y; y <= range.high.y; ++y)
                for (std::uint32_t x = range.low.x; x <= range.high.x; ++x)
                    visit((std::size_t{z} * side + y) * side + x);
    }

    double scale_;
    std::vector<std::uint32_t> patches_;
};

struct FlatTriangle {
    std::array<glm::dvec2, 3> corners;
    double low;
    double high;    // along the first axis
    double bottom;  // along the second
    double top;
    std::uint32_t patch;
    std::uint32_t number;
};

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

// Whether a line along a side of a separates a from b. Overlaps thinner than the margin count as separate.
bool separates(const FlatTriangle& a, const FlatTriangle& b, double margin) {
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 from = a.corners[i];
        const glm::dvec2 side = a.corners[(i + 1) % 3] - from;
        const double length = glm::length(side);
        if (length == 0.0) continue;
        const double inward = cross(side, a.corners[(i + 2) % 3] - from) >= 0.0 ? 1.0 / length : -1.0 / length;
        const auto inside = [&](glm::dvec2 p) { return cross(side, p - from) * inward > margin; };
        if (std::ranges::none_of(b.corners, inside)) return true;
    }
    return false;
}

class LayerFinder {
public:
    LayerFinder(const InstancedMeshes& instanced, const PatchNumbers& patches)
        : instanced_{instanced}, patches_{patches}, layered_(patches.number.size(), false) {}

    std::vector<bool> find() {
        collectRuns();
        std::ranges::sort(runs_, {}, [](const Run& run) {
            return std::tuple{run.cell, run.low, run.instance, run.first};
        });
        for (std::size_t begin = 0; begin < runs_.size();) {
            std::size_t end = begin + 1;  // of a chain of planes, each within the tolerance of the one before
            float reach = runs_[begin].high;
            while (end < runs_.size() && runs_[end].cell == runs_[begin].cell &&
                   runs_[end].low - reach <= static_cast<float>(planeTolerance)) {
                reach = std::max(reach, runs_[end++].high);
            }
            findIn({runs_.data() + begin, end - begin});
            begin = end;
        }
        return std::move(layered_);
    }

private:
    [[nodiscard]] WorldTriangles triangles(std::size_t instance) const {
        return {instanced_.meshOf(instance), instanced_.instances[instance].transform, instanced_.bounds.centre};
    }

    [[nodiscard]] std::uint32_t patchOf(std::uint32_t instance, std::uint32_t triangle) const {
        return patches_.base[instance] + instanced_.topologyOf(instance).patches[triangle];
    }

    [[nodiscard]] std::uint32_t numberOf(std::uint32_t instance, std::uint32_t triangle) const {
        return patches_.number[patchOf(instance, triangle)];
    }

    // Consecutive triangles of one instance, with what holds for all of them.
    struct Block {
        PatchCells::Range cells{};
        std::uint32_t number = 0;  // of their patch; 0: of several
    };
    static constexpr std::uint32_t blockSize = 32;

    // Fills cells_ and blocks_; leaves them empty if they would not help: the triangles are few, or lie in too many
    // cells each.
    void findCells() {
        constexpr std::uint32_t minTriangles = 50'000;
        constexpr std::uint64_t maxVisits = 32;  // of cells, a triangle
        std::uint64_t count = 0;
        for (std::uint32_t i = 0; i < instanced_.instances.size(); ++i) count += triangles(i).count();
        if (count < minTriangles) return;
        cells_.emplace(instanced_.bounds.radius);
        blocks_.resize(instanced_.instances.size());
        std::atomic<std::uint64_t> visits = 0;
        for (std::uint32_t i = 0; i < instanced_.instances.size() && visits <= maxVisits * count; ++i) {
            const std::uint32_t all = triangles(i).count();
            blocks_[i].resize((all + blockSize - 1) / blockSize);
            base::inRanges(all, [&](std::size_t begin, std::size_t end) {
                for (std::size_t b = (begin + blockSize - 1) / blockSize; b * blockSize < end; ++b) {
                    visits += addBlock(i, static_cast<std::uint32_t>(b));
                    if (visits > maxVisits * count) break;
                }
            });
        }
        if (visits <= maxVisits * count) return;
        cells_.reset();
        blocks_.clear();
    }

    // Returns how many cells it has visited.
    std::uint64_t addBlock(std::uint32_t instance, std::uint32_t number) {
        const WorldTriangles world = triangles(instance);
        const std::uint32_t begin = number * blockSize;
        const std::uint32_t end = std::min(begin + blockSize, world.count());
        Block& block = blocks_[instance][number];
        std::array<PatchCells::Range, blockSize> ranges;
        for (std::uint32_t t = begin; t < end; ++t) {
            ranges[t - begin] = cells_->rangeOf(world.triangle(t));
            block.cells = t == begin ? ranges[0] : block.cells.with(ranges[t - begin]);
            if (t == begin) block.number = numberOf(instance, t);
            if (numberOf(instance, t) != block.number) block.number = 0;
        }
        if (block.number != 0) {
            cells_->add(block.cells, block.number);
            return block.cells.count();
        }
        std::uint64_t visits = 0;
        for (std::uint32_t t = begin; t < end; ++t) {
            cells_->add(ranges[t - begin], numberOf(instance, t));
            visits += ranges[t - begin].count();
        }
        return visits;
    }

    // A run at the border of two threads' ranges becomes two runs, which changes no result.
    void collectRuns() {
        findCells();
        std::vector<std::vector<Run>> parts;
        std::size_t count = 0;
        for (std::uint32_t i = 0; i < instanced_.instances.size(); ++i) {
            for (std::vector<Run>&part : base::partsOf(triangles(i).count(), [&](std::size_t begin, std::size_t end) {
                     return runsOf(i, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end));
                 })) {
                count += part.size();
                parts.push_back(std::move(part));
            }
        }
        runs_.reserve(count);
        for (std::vector<Run>& part : parts) {
            runs_.insert(runs_.end(), part.begin(), part.end());
            part = std::vector<Run>{};  // frees the memory before the next part is copied; = {} would not
        }
    }

    // The first triangle behind a triangle's block if no other patch is near; else the triangle itself.
    [[nodiscard]] std::uint32_t behindLoneBlock(std::uint32_t instance, std::uint32_t t) const {
        if (!cells_) return t;
        const Block& block = blocks_[instance][t / blockSize];
        const bool alone = block.number != 0 && !cells_->holdOther(block.cells, block.number);
        return alone ? (t / blockSize + 1) * blockSize : t;
    }

    // Of the triangles that other patches may be near to.
    [[nodiscard]] std::vector<Run> runsOf(std::uint32_t instance, std::uint32_t begin, std::uint32_t end) const {
        const WorldTriangles world = triangles(instance);
        std::vector<Run> runs;
        Run run{0, 0.0F, 0.0F, instance, begin, 0};
        Cells cells;
        std::uint32_t number = 0;
        const auto close = [&] {
            if (run.count == 0) return;
            forEachCell(cells, [&](std::uint32_t cell) { runs.push_back(run), runs.back().cell = cell; });
            run.count = 0;
        };
        for (std::uint32_t t = begin; t < end; ++t) {
            if (const std::uint32_t next = behindLoneBlock(instance, t); next != t) {
                close();
                t = next - 1;
                continue;
            }
            const std::array<glm::dvec3, 3> triangle = world.triangle(t);
            const std::uint32_t itsNumber = numberOf(instance, t);
            const bool alone = cells_ && !cells_->holdOther(cells_->rangeOf(triangle), itsNumber);
            const std::optional<Plane> plane = alone ? std::nullopt : planeOf(triangle, instanced_.bounds.radius);
            if (!plane) {
                close();
                continue;
            }
            const Cells itsCells = cellsOf(plane->normal);
            const float low = std::min(run.low, plane->distance);
            const float high = std::max(run.high, plane->distance);
            if (run.count > 0 && itsCells == cells && itsNumber == number &&
                high - low <= static_cast<float>(planeTolerance)) {
                run = {0, low, high, instance, run.first, run.count + 1};
                continue;
            }
            close();
            run = {0, plane->distance, plane->distance, instance, t, 1};
            cells = itsCells;
            number = itsNumber;
        }
        close();
        return runs;
    }

    // Marks the faces of about one plane that overlap.
    void findIn(std::span<const Run> group) {
        const auto numberOfRun = [&](const Run& run) { return numberOf(run.instance, run.first); };
        const std::uint32_t firstNumber = numberOfRun(group.front());
        if (std::ranges::all_of(group, [&](const Run& run) { return numberOfRun(run) == firstNumber; })) return;

        const std::vector<FlatTriangle> flat = flatten(group);
        const double margin = planeTolerance * instanced_.bounds.radius;
        std::vector<const FlatTriangle*> active;
        for (const FlatTriangle& one : flat) {
            if (active.size() >= stepsLeft_) return markAll(group);
            stepsLeft_ -= active.size();
            std::erase_if(active, [&](const FlatTriangle* other) { return other->high <= one.low; });
            for (const FlatTriangle* other : active) {
                if (one.number == other->number || (layered_[one.patch] && layered_[other->patch])) continue;
                if (one.bottom >= other->top || other->bottom >= one.top) continue;
                if (separates(one, *other, margin) || separates(*other, one, margin)) continue;
                layered_[one.patch] = layered_[other->patch] = true;
            }
            active.push_back(&one);
        }
    }

    // Marks faces without looking. A face that is drawn as a layer but is none only costs time.
    void markAll(std::span<const Run> group) {
        for (const Run& run : group)
            for (std::uint32_t t = run.first; t < run.first + run.count; ++t) layered_[patchOf(run.instance, t)] = true;
    }

    // The triangle of a run whose plane is nearest to the scene's centre.
    [[nodiscard]] std::array<glm::dvec3, 3> nearest(const Run& run) const {
        const WorldTriangles world = triangles(run.instance);
        std::uint32_t t = run.first;
        while (planeOf(world.triangle(t), instanced_.bounds.radius)->distance != run.low) ++t;
        return world.triangle(t);
    }

    // The triangles in two axes of their plane, sorted along the first axis.
    [[nodiscard]] std::vector<FlatTriangle> flatten(std::span<const Run> group) const {
        const auto [a, b, c] = nearest(group.front());
        const glm::dvec3 u = glm::normalize(b - a);
        const glm::dvec3 v = glm::normalize(glm::cross(glm::cross(b - a, c - a), u));
        std::vector<Run> inOrder{group.begin(), group.end()};
        std::ranges::sort(inOrder, {}, [](const Run& run) { return std::pair{run.instance, run.first}; });
        std::vector<FlatTriangle> flat;
        for (const Run& run : inOrder) {
            const WorldTriangles world = triangles(run.instance);
            for (std::uint32_t number = run.first; number < run.first + run.count; ++number) {
                const auto triangle = world.triangle(number);
                FlatTriangle t{{}, 0.0, 0.0, 0.0, 0.0, patchOf(run.instance, number), numberOf(run.instance, number)};
                for (std::size_t i = 0; i < 3; ++i) t.corners[i] = {glm::dot(triangle[i], u), glm::dot(triangle[i], v)};
                t.low = std::min({t.corners[0].x, t.corners[1].x, t.corners[2].x});
                t.high = std::max({t.corners[0].x, t.corners[1].x, t.corners[2].x});
                t.bottom = std::min({t.corners[0].y, t.corners[1].y, t.corners[2].y});
                t.top = std::max({t.corners[0].y, t.corners[1].y, t.corners[2].y});
                flat.push_back(t);
            }
        }
        std::ranges::stable_sort(flat, {}, &FlatTriangle::low);
        return flat;
    }

    const InstancedMeshes& instanced_;
    const PatchNumbers& patches_;
    std::vector<bool> layered_;
    std::optional<PatchCells> cells_;
    std::vector<std::vector<Block>> blocks_;  // of each instance
    std::vector<Run> runs_;
    std::uint64_t stepsLeft_ = maximumSteps;
};

}  // namespace

std::vector<bool> findCoplanarLayers(const InstancedMeshes& instanced, const PatchNumbers& patches) {
    if (patches.count < 2 || instanced.bounds.radius == 0.0) return std::vector<bool>(patches.number.size(), false);
    return LayerFinder{instanced, patches}.find();
}

}  // namespace inkedge::scene
