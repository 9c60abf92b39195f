#include "formats/implicit/polygonise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/message.h"
#include "base/stop.h"
#include "formats/implicit/zeros.h"

namespace inkedge::implicit {
namespace {

constexpr int coarse = 64;              // cubes along the longest side
constexpr int maxParts = 64;            // of a coarse cube along each axis
constexpr double gradientStep = 1e-5;   // of a coarse cube
constexpr double curvatureStep = 0.05;  // likewise
constexpr double sharpest = 0.99;       // of places: what bends more than these is a crease
// Of vertices and indices in a coarse cube that a surface passes through, times the square of its parts: in the mean
// there are four times as many.
constexpr int fewestElements = 4;
constexpr std::size_t groupSize = 200'000;  // fine cubes that are made at once

// The six tetrahedra around a cube's diagonal from corner 0 to corner 7; bit 0 of a corner's number is along x.
constexpr std::array<std::array<int, 4>, 6> tetrahedra{
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

class Polygoniser {
public:
    Polygoniser(const ScalarField& field, const Grain& grain) : field_{field}, grain_{grain} {
        const glm::dvec3 size = grain.bounds.max - grain.bounds.min;
        side_ = std::max({size.x, size.y, size.z}) / coarse;
        for (int axis = 0; axis < 3; ++axis)
            counts_[axis] = std::max(1, static_cast<int>(std::ceil(size[axis] / side_ - 1e-9)));
    }

    Mesh make() {
        findCubes();
        if (cubes_.empty()) base::refuse("expected f = 0 somewhere within the bounds, found it " + signOf());
        chooseParts();
        expectFew(static_cast<std::size_t>(fewestElements * parts_ * parts_) * crossed_.size());
        const std::size_t atOnce =
            std::max<std::size_t>(1, groupSize / static_cast<std::size_t>(parts_ * parts_ * parts_));
        for (std::size_t i = 0; i < cubes_.size(); i += atOnce)
            addCubes(std::span{cubes_}.subspan(i, std::min(atOnce, cubes_.size() - i)));
        if (mesh_.indices.empty()) base::refuse("expected f = 0 somewhere within the bounds, found it nowhere");
        finish();
        return std::move(mesh_);
    }

private:
    [[nodiscard]] glm::dvec3 corner(glm::ivec3 at, double side) const {
        // The last corners lie on the bounds.
        return glm::min(grain_.bounds.min + side * glm::dvec3{at}, grain_.bounds.max);
    }

    [[nodiscard]] std::vector<double> finiteAt(const std::vector<glm::dvec3>& at) const {
        std::vector<double> values = valuesAt(field_, at);
        for (std::size_t i = 0; i < at.size(); ++i) {
            if (std::isfinite(values[i])) continue;
            base::refuse(
                fmt::format("expected finite values of f within the bounds, found {} at ({:.6g}, {:.6g}, {:.6g})",
                            values[i], at[i].x, at[i].y, at[i].z));
        }
        return values;
    }

    // The coarse cubes that the surface passes through, and those beside them: it may pass through a corner of these.
    void findCubes() {
        const glm::ivec3 corners = counts_ + 1;
        std::vector<glm::dvec3> at;
        at.reserve(static_cast<std::size_t>(corners.x) * static_cast<std::size_t>(corners.y * corners.z));
        for (int z = 0; z < corners.z; ++z)
            for (int y = 0; y < corners.y; ++y)
                for (int x = 0; x < corners.x; ++x) at.push_back(corner({x, y, z}, side_));
        const std::vector<double> values = finiteAt(at);
        isOver_ = values.front() >= 0.0;
        const auto number = [](glm::ivec3 of, glm::ivec3 all) {
            return static_cast<std::size_t>(of.x + all.x * (of.y + all.y * of.z));
        };
        std::vector<bool> passed(static_cast<std::size_t>(counts_.x * counts_.y * counts_.z));
        forEachIn(glm::ivec3{0}, counts_, [&](glm::ivec3 cube) {
            int over = 0;
            for (int k = 0; k < 8; ++k)
                over += values[number(cube + glm::ivec3{k & 1, k >> 1 & 1, k >> 2}, corners)] >= 0.0 ? 1 : 0;
            passed[number(cube, counts_)] = over != 0 && over != 8;
        });
        forEachIn(glm::ivec3{0}, counts_, [&](glm::ivec3 cube) {
            bool isNear = false;
            forEachIn(glm::max(cube - 1, 0), glm::min(cube + 2, counts_),
                      [&](glm::ivec3 other) { isNear = isNear || passed[number(other, counts_)]; });
            if (!isNear) return;
            cubes_.push_back(cube);
            if (passed[number(cube, counts_)]) crossed_.push_back(cube);
        });
    }

    template <class Visit>
    static void forEachIn(glm::ivec3 begin, glm::ivec3 end, Visit&& visit) {
        for (int z = begin.z; z < end.z; ++z)
            for (int y = begin.y; y < end.y; ++y)
                for (int x = begin.x; x < end.x; ++x) visit(glm::ivec3{x, y, z});
    }

    [[nodiscard]] std::string signOf() const { return isOver_ ? "over 0 everywhere" : "under 0 everywhere"; }

    [[nodiscard]] std::vector<glm::dvec3> gradientsAt(const std::vector<glm::dvec3>& at) const {
        const double step = gradientStep * side_;
        std::vector<glm::dvec3> around;
        around.reserve(6 * at.size());
        for (const glm::dvec3& p : at) {
            for (int axis = 0; axis < 3; ++axis) {
                for (const double way : {step, -step}) {
                    around.push_back(p);
                    around.back()[axis] += way;
                }
            }
        }
        const std::vector<double> values = valuesAt(field_, around);
        std::vector<glm::dvec3> gradients(at.size());
        for (std::size_t i = 0; i < at.size(); ++i) {
            const double* const v = &values[6 * i];
            gradients[i] = glm::dvec3{v[0] - v[1], v[2] - v[3], v[4] - v[5]} / (2.0 * step);
        }
        return gradients;
    }

    // The unit normals of the surfaces of equal value through some positions; 0 where the field does not change.
    [[nodiscard]] std::vector<glm::dvec3> normalsAt(const std::vector<glm::dvec3>& at) const {
        std::vector<glm::dvec3> normals = gradientsAt(at);
        for (glm::dvec3& normal : normals) normal = unit(normal);
        return normals;
    }

    // How many parts a coarse cube has along each axis: where a surface bends by k, the chord of an edge h long strays
    // by h^2 k / 8.
    void chooseParts() {
        std::vector<double> bends = bendsIn(crossed_);
        const auto high = bends.begin() + static_cast<std::ptrdiff_t>(sharpest * static_cast<double>(bends.size() - 1));
        std::ranges::nth_element(bends, high);
        const double diagonal = std::sqrt(3.0) * side_;
        const double wanted = diagonal * std::sqrt(*high / (8.0 * grain_.deflection));
        parts_ = static_cast<int>(std::clamp(std::ceil(wanted), 1.0, static_cast<double>(maxParts)));
    }

    // In each cube the most that the surface's normal turns, per length, along an axis.
    [[nodiscard]] std::vector<double> bendsIn(const std::vector<glm::ivec3>& cubes) const {
        const double step = curvatureStep * side_;
        std::vector<glm::dvec3> at;
        for (const glm::ivec3& cube : cubes) {
            const glm::dvec3 middle = 0.5 * (corner(cube, side_) + corner(cube + 1, side_));
            at.push_back(middle);
            for (int axis = 0; axis < 3; ++axis) {
                at.push_back(middle);
                at.back()[axis] += step;
            }
        }
        const std::vector<glm::dvec3> normals = normalsAt(at);
        std::vector<double> bends(cubes.size(), 0.0);
        for (std::size_t i = 0; i < cubes.size(); ++i) {
            const glm::dvec3& normal = normals[4 * i];
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 way{0.0};
                way[axis] = 1.0;
                const double along = glm::length(way - glm::dot(way, normal) * normal);
                if (along > 0.1)
                    bends[i] =
                        std::max(bends[i], glm::distance(normal, normals[4 * i + static_cast<std::size_t>(axis) + 1]) /
                                               (step * along));
            }
        }
        return bends;
    }

    static glm::dvec3 unit(glm::dvec3 v) {
        const double length = glm::length(v);
        return length > 0.0 && std::isfinite(length) ? v / length : glm::dvec3{0.0};
    }

    // The corners of the fine cubes in some coarse ones, their values, and the triangles between them.
    void addCubes(std::span<const glm::ivec3> cubes) {
        base::stopIfAsked();
        const int row = parts_ + 1;
        const double side = side_ / parts_;
        std::vector<glm::dvec3> at;
        for (const glm::ivec3& cube : cubes)
            forEachIn(glm::ivec3{0}, glm::ivec3{row},
                      [&](glm::ivec3 p) { at.push_back(corner(parts_ * cube + p, side)); });
        std::vector<double> values = finiteAt(at);
        takeNear(cubes.size(), at, values);
        std::size_t begin = 0;
        for (const glm::ivec3& cube : cubes) {
            forEachIn(glm::ivec3{0}, glm::ivec3{parts_}, [&](glm::ivec3 fine) {
                Corners corners{};
                int over = 0;
                for (int k = 0; k < 8; ++k) {
                    const glm::ivec3 p = fine + glm::ivec3{k & 1, k >> 1 & 1, k >> 2};
                    const std::size_t i = begin + static_cast<std::size_t>(p.x + row * (p.y + row * p.z));
                    corners[static_cast<std::size_t>(k)] = {idOf(parts_ * cube + p), at[i], values[i]};
                    over += values[i] >= 0.0 ? 1 : 0;
                }
                if (over == 0 || over == 8) return;
                for (const auto& tetrahedron : tetrahedra) addTetrahedron(corners, tetrahedron);
            });
            begin += static_cast<std::size_t>(row * row * row);
        }
        expectFew(onSurface_.size() + mesh_.indices.size());
    }

    void expectFew(std::uint64_t elements) const {
        if (elements > grain_.maxElements)
            base::refuse(
                fmt::format("expected at most {} vertices and indices, found more; raise max-vertices or tolerance",
                            grain_.maxElements));
    }

    // Lets the field be 0 in corners that the surface passes near: vertices beside them would make slivers, which are
    // seen edge-on where the surface is not. Labelle and Shewchuk 2007.
    void takeNear(std::size_t cubes, const std::vector<glm::dvec3>& at, std::vector<double>& values) const {
        constexpr double nearCorner = 0.25;  // of a fine cube's side
        const auto row = static_cast<std::size_t>(parts_ + 1);
        const double reach = nearCorner * side_ / parts_;
        std::vector<std::size_t> candidates;
        std::vector<glm::dvec3> positions;
        for (std::size_t cube = 0; cube < cubes; ++cube) {
            const std::size_t begin = cube * row * row * row;
            const std::size_t end = begin + row * row * row;
            double steepest = 0.0;  // step between neighbours
            for (std::size_t i = begin; i < end; ++i)
                for (const std::size_t step : {std::size_t{1}, row, row * row})
                    if (i + step < end) steepest = std::max(steepest, std::abs(values[i + step] - values[i]));
            for (std::size_t i = begin; i < end; ++i) {
                if (!(std::abs(values[i]) < steepest)) continue;
                candidates.push_back(i);
                positions.push_back(at[i]);
            }
        }
        const std::vector<glm::dvec3> gradients = gradientsAt(positions);
        for (std::size_t i = 0; i < candidates.size(); ++i)
            if (std::abs(values[candidates[i]]) < reach * glm::length(gradients[i])) values[candidates[i]] = 0.0;
    }

    struct Corner {
        std::uint64_t id;
        glm::dvec3 at;
        double value;
    };
    using Corners = std::array<Corner, 8>;

    [[nodiscard]] std::uint64_t idOf(glm::ivec3 fine) const {
        const glm::ivec3 all = parts_ * counts_ + 1;
        return static_cast<std::uint64_t>(fine.x) +
               static_cast<std::uint64_t>(all.x) *
                   (static_cast<std::uint64_t>(fine.y) +
                    static_cast<std::uint64_t>(all.y) * static_cast<std::uint64_t>(fine.z));
    }

    void addTetrahedron(const Corners& corners, const std::array<int, 4>& of) {
        std::array<const Corner*, 4> under{};
        std::array<const Corner*, 4> over{};
        std::size_t unders = 0;
        std::size_t overs = 0;
        for (const int k : of) {
            const Corner& c = corners[static_cast<std::size_t>(k)];
            c.value >= 0.0 ? over[overs++] = &c : under[unders++] = &c;
        }
        if (unders == 0 || overs == 0) return;
        const auto vertex = [&](std::size_t u, std::size_t o) {
            const Corner& one = *under[u];
            const Corner& other = *over[o];
            return Vertex{vertexBetween(one, other), glm::mix(one.at, other.at, shareOf(one, other))};
        };
        if (unders == 1) {
            addTriangle(vertex(0, 0), vertex(0, 1), vertex(0, 2), *under[0]);
        } else if (overs == 1) {
            addTriangle(vertex(0, 0), vertex(1, 0), vertex(2, 0), *under[0]);
        } else {
            const std::array quad{vertex(0, 0), vertex(0, 1), vertex(1, 1), vertex(1, 0)};
            addTriangle(quad[0], quad[1], quad[2], *under[0]);
            addTriangle(quad[0], quad[2], quad[3], *under[0]);
        }
    }

    // Where a field that is linear between two corners is 0.
    static double shareOf(const Corner& under, const Corner& over) { return under.value / (under.value - over.value); }

    struct Vertex {
        std::uint32_t number;
        glm::dvec3 at;
    };

    // Its front is turned away from a corner where the field is under 0.
    void addTriangle(const Vertex& a, const Vertex& b, const Vertex& c, const Corner& under) {
        if (a.number == b.number || b.number == c.number || c.number == a.number) return;
        const glm::dvec3 normal = glm::cross(b.at - a.at, c.at - a.at);
        const bool isTurned = glm::dot(normal, under.at - a.at) > 0.0;
        mesh_.indices.insert(mesh_.indices.end(),
                             {a.number, isTurned ? c.number : b.number, isTurned ? b.number : c.number});
    }

    std::uint32_t vertexBetween(const Corner& under, const Corner& over) {
        const std::uint64_t low = std::min(under.id, over.id);
        const bool isCorner = over.value == 0.0;
        const std::uint64_t key =
            isCorner ? over.id * edgeWays : low * edgeWays + wayOf(std::max(under.id, over.id) - low);
        const auto [known, isNew] = vertices_.try_emplace(key, static_cast<std::uint32_t>(onSurface_.size()));
        if (isNew) {
            onSurface_.push_back(glm::mix(under.at, over.at, shareOf(under, over)));
            edges_.emplace_back(under.at, over.at);
            if (isCorner) atCorners_.push_back({known->second, over.at});
        }
        return known->second;
    }

    // An edge goes from one corner into one of 7 directions, of which none is that of a corner itself.
    static constexpr std::uint64_t edgeWays = 8;
    [[nodiscard]] std::uint64_t wayOf(std::uint64_t difference) const {
        for (std::uint64_t k = 1; k < edgeWays; ++k)
            if (idOf(glm::ivec3{static_cast<int>(k & 1U), static_cast<int>(k >> 1U & 1U), static_cast<int>(k >> 2U)}) ==
                difference)
                return k;
        return 0;
    }

    // Moves vertices onto the surface, and makes what is told of them.
    void finish() {
        dropFolded();
        aimCorners();
        onSurface_ = zerosOn(field_, edges_);
        mesh_.origin = 0.5 * (grain_.bounds.min + grain_.bounds.max);
        for (const glm::dvec3& p : onSurface_) mesh_.positions.emplace_back(p - mesh_.origin);
        for (const glm::dvec3& normal : normalsAt(onSurface_)) mesh_.normals.emplace_back(normal);
    }

    // Between corners in which the field is 0, pairs of triangles may lie on each other, back to back: neither is of
    // the surface.
    void dropFolded() {
        const std::size_t count = mesh_.indices.size() / 3;
        std::vector<std::pair<std::array<std::uint32_t, 3>, std::uint32_t>> all(count);
        for (std::uint32_t t = 0; t < count; ++t) {
            std::array<std::uint32_t, 3> corners{};
            std::copy_n(mesh_.indices.begin() + 3 * std::ptrdiff_t{t}, 3, corners.begin());
            std::ranges::sort(corners);
            all[t] = {corners, t};
        }
        std::ranges::sort(all);
        std::vector<bool> goes(count, false);
        for (std::size_t i = 0; i + 1 < count; ++i)
            if (all[i].first == all[i + 1].first) goes[all[i].second] = goes[all[i + 1].second] = true;
        std::vector<std::uint32_t> kept;
        kept.reserve(mesh_.indices.size());
        for (std::size_t i = 0; i < mesh_.indices.size(); ++i)
            if (!goes[i / 3]) kept.push_back(mesh_.indices[i]);
        mesh_.indices = std::move(kept);
    }

    // Vertices in corners are looked for straight from there, where the field goes to 0.
    void aimCorners() {
        std::vector<glm::dvec3> at;
        for (const AtCorner& each : atCorners_) at.push_back(each.corner);
        const std::vector<double> values = valuesAt(field_, at);
        std::vector<glm::dvec3> gradients = gradientsAt(at);
        std::vector<glm::dvec3> beyond = at;
        for (std::size_t i = 0; i < at.size(); ++i)
            for (int axis = 0; axis < 3; ++axis)  // what is on the bounds stays there
                if (at[i][axis] == grain_.bounds.min[axis] || at[i][axis] == grain_.bounds.max[axis])
                    gradients[i][axis] = 0.0;
        for (std::size_t i = 0; i < at.size(); ++i)
            if (const double square = glm::dot(gradients[i], gradients[i]); square > 0.0)
                beyond[i] -= 2.0 * values[i] / square * gradients[i];
        const std::vector<double> valuesBeyond = valuesAt(field_, beyond);
        for (std::size_t i = 0; i < at.size(); ++i) {
            auto& [under, over] = edges_[atCorners_[i].vertex];
            under = values[i] < 0.0 ? at[i] : beyond[i];
            over = values[i] < 0.0 ? beyond[i] : at[i];
            const bool goesThrough = std::isfinite(valuesBeyond[i]) && (values[i] < 0.0) != (valuesBeyond[i] < 0.0);
            if (!goesThrough) under = over = at[i];
        }
    }

    const ScalarField& field_;
    const Grain& grain_;
    double side_ = 0.0;  // of a coarse cube
    glm::ivec3 counts_{1};
    int parts_ = 1;
    bool isOver_ = false;  // the field in one corner
    std::vector<glm::ivec3> cubes_;
    std::vector<glm::ivec3> crossed_;
    std::unordered_map<std::uint64_t, std::uint32_t> vertices_;  // by their edges
    std::vector<glm::dvec3> onSurface_;                          // one per vertex
    std::vector<Edge> edges_;                                    // one per vertex
    struct AtCorner {
        std::uint32_t vertex;
        glm::dvec3 corner;
    };
    std::vector<AtCorner> atCorners_;
    Mesh mesh_;
};

}  // namespace

Mesh polygonise(const ScalarField& field, const Grain& grain) { return Polygoniser{field, grain}.make(); }

}  // namespace inkedge::implicit
