#include "lines/find/contour_finders.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cfloat>
#include <cmath>
#include <span>
#include <utility>

#include <inkedge/error.h>

#include "base/parallel.h"

namespace inkedge::lines {
namespace {

// A set of numbers below a limit.
class Marks {
public:
    explicit Marks(std::size_t count) : words_((count + 63) / 64, 0) {}
    // Returns whether the number was not yet in the set.
    bool add(std::uint32_t i) {
        std::uint64_t& word = words_[i / 64];
        const std::uint64_t bit = std::uint64_t{1} << (i % 64);
        const bool fresh = (word & bit) == 0;
        word |= bit;
        return fresh;
    }
    [[nodiscard]] bool holds(std::uint32_t i) const { return (words_[i / 64] >> (i % 64) & 1U) != 0; }

private:
    std::vector<std::uint64_t> words_;
};

// splitmix64: the same numbers on every machine.
class RandomNumbers {
public:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }
    std::size_t below(std::size_t limit) { return static_cast<std::size_t>(next() % limit); }
    double share() { return static_cast<double>(next() >> 11U) * 0x1p-53; }

private:
    std::uint64_t state_ = 0;
};

// The angle between the faces' normals at an edge: radians, 0 to pi. The edge is a contour in a share of angle / pi of
// all views.
double bendOf(const MeshEdges& edges, std::uint32_t e) {
    const double cosine =
        glm::dot(edges.faceNormals[edges.shared.faces[2 * e]], edges.faceNormals[edges.shared.faces[2 * e + 1]]);
    return std::acos(std::clamp(edges.shared.against[e] != 0 ? -cosine : cosine, -1.0, 1.0));
}

// As many samples as there are edges, in random order. The frequency of an edge is proportional to its bend.
std::vector<std::uint32_t> drawSamples(const MeshEdges& edges) {
    const std::size_t count = edges.shared.halfEdges.size();
    std::vector<float> weights(count);
    base::inRanges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e)
            weights[e] = static_cast<float>(bendOf(edges, static_cast<std::uint32_t>(e)));
    });
    double sum = 0.0;
    for (const float weight : weights) sum += double{weight};
    std::vector<std::uint32_t> samples;
    samples.reserve(count);
    RandomNumbers numbers;
    double reached = numbers.share();
    const double scale = sum > 0.0 ? static_cast<double>(count) / sum : 0.0;
    for (std::uint32_t e = 0; e < count; ++e)
        for (reached += double{weights[e]} * scale; reached >= 1.0; reached -= 1.0) samples.push_back(e);
    for (std::size_t i = samples.size(); i > 1; --i) std::swap(samples[i - 1], samples[numbers.below(i)]);
    return samples;
}

}  // namespace

struct ContourSearch::Samples {
    std::vector<std::uint32_t> order;        // into MeshEdges::shared
    std::vector<std::uint32_t> pointBegins;  // into pointEdges: one per point, and the end
    std::vector<std::uint32_t> pointEdges;   // into MeshEdges::shared: those that end at a point

    [[nodiscard]] std::span<const std::uint32_t> at(std::uint32_t point) const {
        return std::span{pointEdges}.subspan(pointBegins[point], pointBegins[point + 1] - pointBegins[point]);
    }
};

ContourSearch::ContourSearch(const Mesh& mesh, const mesh::MeshTopology& topology, const MeshEdges& edges)
    : mesh_{mesh}, topology_{topology}, edges_{edges} {
    const std::size_t count = edges.faceNormals.size();
    for (std::vector<float>* const part : {&planes_.x, &planes_.y, &planes_.z, &planes_.offset}) part->resize(count);
    base::inRanges(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const glm::dvec3 normal = edges.faceNormals[t];
            planes_.x[t] = static_cast<float>(normal.x);
            planes_.y[t] = static_cast<float>(normal.y);
            planes_.z[t] = static_cast<float>(normal.z);
            planes_.offset[t] = static_cast<float>(glm::dot(normal, glm::dvec3{mesh.positions[mesh.indices[3 * t]]}));
        }
    });
    for (const float offset : planes_.offset) planes_.largestOffset = std::max(planes_.largestOffset, std::abs(offset));
    for (const float sine : edges.edgeOnSines) planes_.largestSine = std::max(planes_.largestSine, sine);
    for (const glm::vec3 p : mesh.positions) planes_.reach = std::max(planes_.reach, glm::length(glm::dvec3{p}));
}

ContourSearch::~ContourSearch() = default;

FoundContours ContourSearch::find(const MeshEye& eye, ContourFinder finder, ContourMemory& memory) const {
    constexpr std::size_t worthSampling = 4096;  // edges
    if (finder == ContourFinder::Gauss) return {searchMap(eye), {}};
    if (finder == ContourFinder::Random && edges_.shared.halfEdges.size() > worthSampling)
        return {searchAtRandom(eye, memory), {}};
    FoundContours found;
    found.facing = findFacing(eye);
    found.edges = findDiffering(eye, found.facing);
    return found;
}

// Compares n . C > n . p in floats, which is right if the two sides differ by more than the rounding, and than faces
// that are seen edge-on may. The other faces, about one in a thousand, are looked at again in doubles.
std::vector<Facing> ContourSearch::findFacing(const MeshEye& eye) const {
    constexpr std::size_t blockSize = 512;
    const glm::vec3 to{eye.orthographic ? -eye.direction : eye.position};
    const float scale = eye.orthographic ? 0.0F : 1.0F;
    const float size = std::abs(to.x) + std::abs(to.y) + std::abs(to.z) + scale * planes_.largestOffset;
    const auto farthest = static_cast<float>(glm::length(glm::dvec3{to}) + double{scale} * planes_.reach);
    const float doubt = 8.0F * FLT_EPSILON * size + 1.001F * planes_.largestSine * farthest + FLT_MIN;
    std::vector<Facing> facing(planes_.x.size());
    base::inRanges(facing.size(), [&](std::size_t rangeBegin, std::size_t rangeEnd) {
        for (std::size_t begin = rangeBegin; begin < rangeEnd; begin += blockSize) {
            const std::size_t end = std::min(begin + blockSize, rangeEnd);
            std::array<float, blockSize> heights;
            std::int32_t doubtful = 0;
            for (std::size_t t = begin; t < end; ++t) {
                const float height =
                    planes_.x[t] * to.x + planes_.y[t] * to.y + planes_.z[t] * to.z - planes_.offset[t] * scale;
                heights[t - begin] = height;
                doubtful |= std::abs(height) > doubt ? 0 : 1;
            }
            for (std::size_t t = begin; t < end; ++t)
                facing[t] = heights[t - begin] > 0.0F ? Facing::Front : Facing::Back;
            if (doubtful == 0) continue;
            for (std::size_t t = begin; t < end; ++t)
                if (!(std::abs(heights[t - begin]) > doubt))
                    facing[t] = this->facing(eye, static_cast<std::uint32_t>(t));
        }
    });
    return facing;
}

// Goes through the edge table: an exclusive or per edge.
std::vector<std::uint32_t> ContourSearch::findDiffering(const MeshEye& eye, const std::vector<Facing>& facing) const {
    constexpr std::size_t batch = 8;
    const MeshEdges::Shared& shared = edges_.shared;
    std::mutex mutex;
    std::vector<std::pair<std::size_t, std::vector<std::uint32_t>>> pieces;
    base::inRanges(shared.halfEdges.size(), [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> found;
        const auto differs = [&](std::size_t e) -> std::uint8_t {
            return static_cast<std::uint8_t>(facing[shared.faces[2 * e]]) ^
                   static_cast<std::uint8_t>(facing[shared.faces[2 * e + 1]]) ^ shared.against[e];
        };
        const auto take = [&](std::size_t e) {
            if (isContour(eye, static_cast<std::uint32_t>(e), facing[shared.faces[2 * e]],
                          facing[shared.faces[2 * e + 1]]))
                found.push_back(static_cast<std::uint32_t>(e));
        };
        std::size_t e = begin;
        for (; e + batch <= end; e += batch) {
            std::array<std::uint8_t, batch> differ;
            for (std::size_t k = 0; k < batch; ++k) differ[k] = differs(e + k);
            if (std::bit_cast<std::uint64_t>(differ) == 0) continue;
            for (std::size_t k = 0; k < batch; ++k)
                if (differ[k] != 0) take(e + k);
        }
        for (; e < end; ++e)
            if (differs(e) != 0) take(e);
        const std::scoped_lock lock{mutex};
        pieces.emplace_back(begin, std::move(found));
    });
    if (pieces.size() == 1) return std::move(pieces.front().second);
    std::ranges::sort(pieces, {}, [](const auto& piece) { return piece.first; });
    std::vector<std::uint32_t> all;
    for (const auto& [begin, found] : pieces) all.insert(all.end(), found.begin(), found.end());
    return all;
}

bool ContourSearch::isContour(const MeshEye& eye, std::uint32_t edge) const {
    return isContour(eye, edge, facing(eye, edges_.shared.faces[2 * edge]),
                     facing(eye, edges_.shared.faces[2 * edge + 1]));
}

bool ContourSearch::isContour(const MeshEye& eye, std::uint32_t edge, Facing first, Facing second) const {
    const bool firstIsEdgeOn = first == Facing::EdgeOn;
    if (!firstIsEdgeOn && second != Facing::EdgeOn) return (first != second) != (edges_.shared.against[edge] != 0);
    if (first == second) return false;
    const std::uint32_t edgeOn = edges_.shared.faces[2 * edge + (firstIsEdgeOn ? 0 : 1)];
    return !liesBefore(eye, edgeOn, edges_.shared.halfEdges[edge]);
}

bool ContourSearch::liesBefore(const MeshEye& eye, std::uint32_t t, std::uint32_t halfEdge) const {
    const auto corner = [&](std::uint32_t h) { return glm::dvec3{mesh_.positions[mesh_.indices[h]]}; };
    const glm::dvec3 from = corner(halfEdge);
    const glm::dvec3 along = glm::normalize(corner(mesh::nextHalfEdge(halfEdge)) - from);
    glm::dvec3 farthest{0.0};  // from the edge, across it
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
        const glm::dvec3 to = corner(h) - from;
        const glm::dvec3 across = to - glm::dot(to, along) * along;
        if (glm::dot(across, across) > glm::dot(farthest, farthest)) farthest = across;
    }
    return glm::dot(farthest, eye.view(from)) < 0.0;
}

std::vector<std::uint32_t> ContourSearch::searchMap(const MeshEye& eye) const {
    if (!eye.orthographic) {
        throw Error{Error::Kind::Usage,
                    "--contour-finder: expected an orthographic camera for gauss, found a perspective one; add "
                    "--camera-orthographic or take every"};
    }
    std::vector<std::uint32_t> near;
    map().findNear(eye.direction, near);
    std::erase_if(near, [&](std::uint32_t e) { return !isContour(eye, e); });
    std::ranges::sort(near);
    return near;
}

// One view of the randomized search: the edges that were tested and found so far.
class ContourSearch::Walk {
public:
    Walk(const ContourSearch& search, const MeshEye& eye)
        : search_{search},
          samples_{search.samples()},
          eye_{eye},
          tested_{search.edges_.shared.halfEdges.size()},
          isFound_{search.edges_.shared.halfEdges.size()} {}

    [[nodiscard]] bool isFound(std::uint32_t edge) const { return isFound_.holds(edge); }

    // Tests an edge. If it is a contour the contour is followed over all edges at its end points.
    bool test(std::uint32_t edge) {
        if (!tested_.add(edge) || !search_.isContour(eye_, edge)) return false;
        open_.push_back(edge);
        while (!open_.empty()) {
            const std::uint32_t from = open_.back();
            open_.pop_back();
            found_.push_back(from);
            isFound_.add(from);
            eachBeside(from, [&](std::uint32_t beside) {
                if (tested_.add(beside) && search_.isContour(eye_, beside)) open_.push_back(beside);
            });
        }
        return true;
    }

    // Walks from an edge that was a contour in the last view to an edge that is a contour now, over edges whose faces
    // are seen ever more edge-on.
    void descend(std::uint32_t edge) {
        constexpr int maxSteps = 64;
        double smallest = distanceFromPlane(edge);
        for (int step = 0; step < maxSteps; ++step) {
            std::uint32_t next = edge;
            eachBeside(edge, [&](std::uint32_t beside) {
                const double other = distanceFromPlane(beside);
                if (other < smallest) {
                    smallest = other;
                    next = beside;
                }
            });
            if (next == edge) return;
            edge = next;
            if (test(edge) || isFound(edge)) return;
        }
    }

    [[nodiscard]] std::vector<std::uint32_t> found() && {
        std::ranges::sort(found_);
        return std::move(found_);
    }

private:
    template <class Visit>
    void eachBeside(std::uint32_t edge, Visit visit) const {
        const std::uint32_t h = search_.edges_.shared.halfEdges[edge];
        for (const std::uint32_t corner : {h, mesh::nextHalfEdge(h)})
            for (const std::uint32_t beside : samples_.at(search_.topology_.points[corner])) visit(beside);
    }

    // The distance of the eye from the plane of an edge's first face; 0: the face is seen edge-on.
    [[nodiscard]] double distanceFromPlane(std::uint32_t edge) const {
        const std::uint32_t t = search_.edges_.shared.faces[2 * edge];
        const glm::dvec3 corner{search_.mesh_.positions[search_.mesh_.indices[3 * std::size_t{t}]]};
        return std::abs(glm::dot(search_.edges_.faceNormals[t], eye_.view(corner)));
    }

    const ContourSearch& search_;
    const Samples& samples_;
    const MeshEye& eye_;
    Marks tested_;
    Marks isFound_;
    std::vector<std::uint32_t> open_;
    std::vector<std::uint32_t> found_;
};

std::vector<std::uint32_t> ContourSearch::searchAtRandom(const MeshEye& eye, ContourMemory& memory) const {
    constexpr double samplesPerRoot = 16.0;  // a view tests this times the root of the number of edges
    constexpr std::size_t firstView = 4;     // times as many in the first view
    // Of the last view's edges that are no contours any more, one in so many descends: its neighbours lead the same
    // way.
    constexpr std::size_t descentsOneIn = 16;
    const std::vector<std::uint32_t>& order = samples().order;
    Walk walk{*this, eye};
    std::size_t lost = 0;
    for (const std::uint32_t edge : memory.last)
        if (!walk.test(edge) && !walk.isFound(edge) && lost++ % descentsOneIn == 0) walk.descend(edge);
    auto tests =
        static_cast<std::size_t>(samplesPerRoot * std::sqrt(static_cast<double>(edges_.shared.halfEdges.size())));
    if (memory.last.empty()) tests *= firstView;
    for (std::size_t i = 0; i < std::min(tests, order.size()); ++i) {
        walk.test(order[memory.sample % order.size()]);
        ++memory.sample;
    }
    memory.last = std::move(walk).found();
    return memory.last;
}

const ContourSearch::Samples& ContourSearch::samples() const {
    const std::scoped_lock lock{mutex_};
    if (samples_) return *samples_;
    auto made = std::make_unique<Samples>();
    made->order = drawSamples(edges_);
    const MeshEdges::Shared& shared = edges_.shared;
    made->pointBegins.assign(std::size_t{topology_.pointCount} + 1, 0);
    const auto eachEnd = [&](auto visit) {
        for (std::uint32_t e = 0; e < shared.halfEdges.size(); ++e) {
            const std::uint32_t h = shared.halfEdges[e];
            visit(topology_.points[h], e);
            visit(topology_.points[mesh::nextHalfEdge(h)], e);
        }
    };
    eachEnd([&](std::uint32_t point, std::uint32_t) { ++made->pointBegins[point + 1]; });
    for (std::size_t p = 0; p < topology_.pointCount; ++p) made->pointBegins[p + 1] += made->pointBegins[p];
    made->pointEdges.resize(2 * shared.halfEdges.size());
    std::vector<std::uint32_t> next = made->pointBegins;
    eachEnd([&](std::uint32_t point, std::uint32_t e) { made->pointEdges[next[point]++] = e; });
    samples_ = std::move(made);
    return *samples_;
}

const GaussMap& ContourSearch::map() const {
    const std::scoped_lock lock{mutex_};
    if (!map_) map_ = std::make_unique<GaussMap>(edges_);
    return *map_;
}

std::size_t ContourSearch::prepare(ContourFinder finder) const {
    if (finder == ContourFinder::Gauss) return map().bytes();
    if (finder == ContourFinder::Every) return 4 * planes_.x.capacity() * sizeof(float);
    const Samples& made = samples();
    return (made.order.capacity() + made.pointBegins.capacity() + made.pointEdges.capacity()) * sizeof(std::uint32_t);
}

}  // namespace inkedge::lines
