#include "mesh/surface_form.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "base/stop.h"
#include "mesh/fans.h"
#include "mesh/heat_smoothing.h"
#include "mesh/tensors.h"
#include "mesh/z_order.h"

namespace inkedge::mesh {
namespace {

glm::dvec3 unit(glm::dvec3 v) {
    const double length = glm::length(v);
    return length > 0.0 ? v / length : v;
}

double angleBetween(glm::dvec3 a, glm::dvec3 b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

class FormBuilder {
public:
    FormBuilder(const Mesh& mesh, const MeshTopology& topology) : mesh_{mesh}, topology_{topology} {}

    SurfaceForm build(double featureSize) {
        numberFans();
        measureSurfaces(featureSize);
        markOneSided();
        sumNormals();
        const HeatSmoothing smoothing = smoothingOf();
        makeFrames();
        fitTensors();
        std::vector<SpaceTensor2> tensors = tensorsInSpace();
        fillOneSided(tensors);
        // The tensor, not the normals that it is of: smoothing keeps what bends the same everywhere, up to borders.
        smoothing.smooth(tensors, 1.0);
        smoothing.smooth(normals_, 1.0);
        makeFrames();
        takeTensors(tensors);
        fitDerivatives();
        std::vector<SpaceTensor3> derivatives = derivativesInSpace();
        // Differences within faces are as coarse as these.
        smoothing.smooth(derivatives, coarseness_);
        takeDerivatives(derivatives);
        takePoints();
        return std::move(form_);
    }

private:
    // Positions in feature sizes.
    [[nodiscard]] std::array<glm::dvec3, 3> cornersOf(std::uint32_t t) const {
        const double unit = unitOf(t);
        std::array<glm::dvec3, 3> corners{};
        for (std::uint32_t k = 0; k < 3; ++k) corners[k] = unit * glm::dvec3{mesh_.positions[mesh_.indices[3 * t + k]]};
        return corners;
    }
    [[nodiscard]] double unitOf(std::uint32_t t) const { return units_[topology_.patches[t]]; }
    [[nodiscard]] bool counts(std::uint32_t t) const { return topology_.originals[t] == t && unitOf(t) > 0.0; }

    // The first corners of fans, in an order in which neighbours are near: smoothing goes through all many times.
    [[nodiscard]] std::vector<ZOrderKey> fanKeys() const {
        const auto position = [&](std::uint32_t c) { return mesh_.positions[mesh_.indices[c]]; };
        glm::vec3 low = position(0);
        glm::vec3 high = low;
        for (const glm::vec3& p : mesh_.positions) low = glm::min(low, p), high = glm::max(high, p);
        const ZOrder order{low, high};
        std::vector<ZOrderKey> keys;
        for (std::uint32_t c = 0; c < form_.fans.size(); ++c)
            if (form_.fans[c] == c) keys.push_back({order.key(position(c)), c});
        sortByKey(keys);
        return keys;
    }

    void numberFans() {
        form_.fans = findFans(topology_);
        const std::vector<ZOrderKey> keys = fanKeys();
        const std::size_t count = keys.size();
        std::vector<std::uint32_t> numbers(form_.fans.size());  // of first corners
        for (std::uint32_t fan = 0; fan < count; ++fan) numbers[keys[fan].index] = fan;
        for (std::uint32_t& fan : form_.fans) fan = numbers[fan];
        begins_.assign(count + 1, 0);
        for (const std::uint32_t fan : form_.fans) ++begins_[fan + 1];
        for (std::size_t i = 0; i < count; ++i) begins_[i + 1] += begins_[i];
        corners_.resize(form_.fans.size());
        std::vector<std::uint32_t> next{begins_.begin(), begins_.end() - 1};
        for (std::uint32_t c = 0; c < form_.fans.size(); ++c) corners_[next[form_.fans[c]]++] = c;
    }

    void measureSurfaces(double featureSize) {
        struct Sums {
            double area = 0.0;
            double length = 0.0;
            double edges = 0.0;
        };
        std::vector<Sums> sums(topology_.patchCount());
        for (std::uint32_t t = 0; t < topology_.patches.size(); ++t) {
            if (topology_.originals[t] != t) continue;
            std::array<glm::dvec3, 3> p{};
            for (std::uint32_t k = 0; k < 3; ++k) p[k] = glm::dvec3{mesh_.positions[mesh_.indices[3 * t + k]]};
            Sums& sum = sums[topology_.surfaceOf(t)];
            sum.area += 0.5 * glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
            for (std::size_t k = 0; k < 3; ++k) sum.length += glm::distance(p[k], p[(k + 1) % 3]);
            sum.edges += 3.0;
        }
        double edges = 0.0;
        for (std::size_t patch = 0; patch < sums.size(); ++patch) {
            const Sums& sum = sums[topology_.surfaces[patch]];
            const double radius = std::sqrt(sum.area / (4.0 * std::numbers::pi));
            form_.featureSizes.push_back(featureSize * radius);
            form_.resolutions.push_back(radius > 0.0 ? std::max(featureSize * radius, sum.length / sum.edges) : 0.0);
            units_.push_back(radius > 0.0 ? 1.0 / form_.featureSizes[patch] : 0.0);
            if (radius == 0.0 || sums[patch].edges == 0.0) continue;
            const double edge = sum.length / sum.edges;
            coarseness_ += sum.length * edge / (form_.resolutions[patch] * form_.resolutions[patch]);
            edges += sum.edges;
        }
        if (edges > 0.0) coarseness_ /= edges;
    }

    [[nodiscard]] std::size_t fanCount() const { return begins_.size() - 1; }

    template <class Work>
    void onFans(Work&& work) const {
        base::inRanges(fanCount(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) work(i);
        });
    }

    [[nodiscard]] glm::dvec3 normalOf(std::size_t fan) const {
        return {normals_[fan][0], normals_[fan][1], normals_[fan][2]};
    }
    void setNormal(std::size_t fan, glm::dvec3 n) {
        normals_[fan] = {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
    }

    // Within surfaces exact on spheres, Max 1999; at their ends, where a cylinder's sides may be long triangles that
    // all reach from end to end, exact on these: by angles, Thürmer and Wüthrich 1998.
    void sumNormals() {
        normals_.resize(fanCount());
        onFans([&](std::size_t fan) {
            glm::dvec3 sum{0.0};
            for (std::uint32_t i = begins_[fan]; i < begins_[fan + 1]; ++i) {
                const std::uint32_t c = corners_[i];
                if (!counts(c / 3)) continue;
                const std::array<glm::dvec3, 3> p = cornersOf(c / 3);
                const glm::dvec3 one = p[(c + 1) % 3] - p[c % 3];
                const glm::dvec3 other = p[(c + 2) % 3] - p[c % 3];
                const glm::dvec3 cross = glm::cross(one, other);
                const double squares = glm::dot(one, one) * glm::dot(other, other);
                if (squares == 0.0) continue;
                sum += oneSided_[fan] == 0 ? cross / squares : angleBetween(one, other) * unit(cross);
            }
            setNormal(fan, unit(sum));
        });
    }

    // Fans at borders and creases, and those whose faces are wound against each other.
    void markOneSided() {
        oneSided_.assign(fanCount(), 0);
        for (std::uint32_t h = 0; h < topology_.twins.size(); ++h) {
            const std::uint32_t twin = topology_.twins[h];
            const bool goesOn =
                isHalfEdge(twin) && !topology_.creases[h] && topology_.points[h] != topology_.points[twin];
            if (goesOn) continue;
            oneSided_[form_.fans[h]] = 1;
            oneSided_[form_.fans[nextHalfEdge(h)]] = 1;
        }
    }

    // Counts lengths in resolutions.
    [[nodiscard]] HeatSmoothing smoothingOf() const {
        constexpr double maxCotangent = 20.0;  // of an angle of 3 degrees: slivers conduct no better
        std::vector<double> areas(fanCount(), 0.0);
        std::vector<double> halves(topology_.twins.size(), 0.0);
        for (std::uint32_t t = 0; t < topology_.patches.size(); ++t) {
            if (!counts(t)) continue;
            const std::array<glm::dvec3, 3> p = cornersOf(t);
            const double twiceArea = glm::length(glm::cross(p[1] - p[0], p[2] - p[0]));
            if (twiceArea == 0.0) continue;
            for (std::uint32_t k = 0; k < 3; ++k) {
                const std::uint32_t opposite = (k + 2) % 3;  // of half-edge k
                areas[form_.fans[3 * t + k]] += twiceArea / 6.0;
                const double cotangent = glm::dot(p[k] - p[opposite], p[(k + 1) % 3] - p[opposite]) / twiceArea;
                halves[3 * t + k] = 0.5 * std::clamp(cotangent, -maxCotangent, maxCotangent);
            }
        }
        std::vector<HeatSmoothing::Edge> edges;
        edges.reserve(topology_.twins.size() / 2);
        for (std::uint32_t h = 0; h < topology_.twins.size(); ++h) {
            const std::uint32_t twin = topology_.twins[h];
            const bool goesOn = isHalfEdge(twin) && !topology_.creases[h];
            if (goesOn && twin < h) continue;
            const double conductance = halves[h] + (goesOn ? halves[twin] : 0.0);
            const double width = form_.resolutions[topology_.patches[h / 3]] * unitOf(h / 3);
            if (conductance > 0.0)
                edges.push_back({form_.fans[h], form_.fans[nextHalfEdge(h)], conductance * width * width});
        }
        return {edges, areas};
    }

    void makeFrames() {
        frames_.resize(fanCount());
        onFans([&](std::size_t fan) {
            const glm::dvec3 n = normalOf(fan);
            frames_[fan] = frameOf(n == glm::dvec3{0.0} ? glm::dvec3{0.0, 0.0, 1.0} : glm::normalize(n));
        });
    }

    // A face's frame, edges and shares of area: null for one of no area.
    struct Face {
        Frame frame;
        std::array<glm::dvec2, 3> edges;  // the edge from each corner to the next, in the frame
        std::array<double, 3> shares;     // of the area, of its corners
    };
    [[nodiscard]] std::optional<Face> faceOf(std::uint32_t t) const {
        if (!counts(t)) return std::nullopt;
        const std::array<glm::dvec3, 3> p = cornersOf(t);
        const glm::dvec3 cross = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double twiceArea = glm::length(cross);
        const double length = glm::length(p[1] - p[0]);
        if (!(twiceArea > 0.0) || !(length > 0.0)) return std::nullopt;
        Face face;
        face.frame.normal = cross / twiceArea;
        face.frame.u = (p[1] - p[0]) / length;
        face.frame.v = glm::cross(face.frame.normal, face.frame.u);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 edge = p[(k + 1) % 3] - p[k];
            face.edges[k] = {glm::dot(edge, face.frame.u), glm::dot(edge, face.frame.v)};
        }
        face.shares = voronoiShares(p, 0.5 * twiceArea);
        return face;
    }

    [[nodiscard]] bool isOneSided(std::uint32_t t) const {
        return oneSided_[form_.fans[3 * t]] != 0 || oneSided_[form_.fans[3 * t + 1]] != 0 ||
               oneSided_[form_.fans[3 * t + 2]] != 0;
    }

    // Fits a tensor in each face, and averages them at the fans.
    // @param fit  a face's number and itself to its tensor, in its frame
    // @param turn  a tensor to another frame
    template <class Tensor, class Fit, class Turn>
    std::vector<Tensor> fitted(Fit&& fit, Turn&& turn) const {
        std::vector<Tensor> ofFaces(topology_.patches.size(), Tensor{});
        std::vector<std::array<float, 3>> shares(ofFaces.size());
        base::inRanges(ofFaces.size(), [&](std::size_t begin, std::size_t end) {
            for (auto t = static_cast<std::uint32_t>(begin); t < end; ++t) {
                const std::optional<Face> face = faceOf(t);
                if (!face) continue;
                ofFaces[t] = fit(t, *face);
                for (std::size_t k = 0; k < 3; ++k) shares[t][k] = static_cast<float>(face->shares[k]);
            }
        });
        std::vector<Tensor> sums(fanCount(), Tensor{});
        onFans([&](std::size_t fan) {
            for (const bool all : {false, true}) {
                double weight = 0.0;
                for (std::uint32_t i = begins_[fan]; i < begins_[fan + 1]; ++i) {
                    const std::uint32_t t = corners_[i] / 3;
                    const auto share = static_cast<double>(shares[t][corners_[i] % 3]);
                    if (share <= 0.0 || (!all && isOneSided(t))) continue;
                    const std::optional<Turned> axes = turnedInto(frames_[fan], faceOf(t)->frame);
                    if (!axes) continue;
                    const Tensor own = turn(ofFaces[t], *axes);
                    for (std::size_t k = 0; k < own.size(); ++k) sums[fan][k] += share * own[k];
                    weight += share;
                }
                if (weight == 0.0) continue;
                for (double& component : sums[fan]) component /= weight;
                return;
            }
        });
        return sums;
    }

    void fitTensors() {
        tensors_ = fitted<Tensor2>(
            [&](std::uint32_t t, const Face& face) {
                Tensor2 right{};
                double uu = 0.0;
                double uv = 0.0;
                double vv = 0.0;
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const glm::dvec2 e = face.edges[k];
                    const glm::dvec3 turn =
                        frames_[form_.fans[3 * t + (k + 1) % 3]].normal - frames_[form_.fans[3 * t + k]].normal;
                    const glm::dvec2 d{glm::dot(turn, face.frame.u), glm::dot(turn, face.frame.v)};
                    uu += e.x * e.x;
                    uv += e.x * e.y;
                    vv += e.y * e.y;
                    right[0] += e.x * d.x;
                    right[1] += e.x * d.y + e.y * d.x;
                    right[2] += e.y * d.y;
                }
                return solveTridiagonal<3>({uu, uu + vv, vv}, uv, right);
            },
            [](const Tensor2& t, const Turned& axes) {
                return Tensor2{along(t, axes.u, axes.u), along(t, axes.u, axes.v), along(t, axes.v, axes.v)};
            });
    }

    void fitDerivatives() {
        derivatives_ = fitted<Tensor3>(
            [&](std::uint32_t t, const Face& face) {
                std::array<Tensor2, 3> atCorners{};
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const std::uint32_t fan = form_.fans[3 * t + k];
                    const std::optional<Turned> axes = turnedInto(face.frame, frames_[fan]);
                    if (!axes) return Tensor3{};
                    const Tensor2& own = tensors_[fan];
                    atCorners[k] = {along(own, axes->u, axes->u), along(own, axes->u, axes->v),
                                    along(own, axes->v, axes->v)};
                }
                Tensor3 right{};
                double uu = 0.0;
                double uv = 0.0;
                double vv = 0.0;
                for (std::uint32_t k = 0; k < 3; ++k) {
                    const glm::dvec2 e = face.edges[k];
                    const Tensor2& from = atCorners[k];
                    const Tensor2& to = atCorners[(k + 1) % 3];
                    uu += e.x * e.x;
                    uv += e.x * e.y;
                    vv += e.y * e.y;
                    right[0] += e.x * (to[0] - from[0]);
                    right[1] += e.x * (to[1] - from[1]) + e.y * (to[0] - from[0]);
                    right[2] += e.x * (to[2] - from[2]) + e.y * (to[1] - from[1]);
                    right[3] += e.y * (to[2] - from[2]);
                }
                return solveTridiagonal<4>({uu, uu + vv, uu + vv, vv}, uv, right);
            },
            [](const Tensor3& t, const Turned& axes) {
                return Tensor3{along(t, axes.u, axes.u, axes.u), along(t, axes.u, axes.u, axes.v),
                               along(t, axes.u, axes.v, axes.v), along(t, axes.v, axes.v, axes.v)};
            });
    }

    [[nodiscard]] std::vector<SpaceTensor2> tensorsInSpace() const {
        std::vector<SpaceTensor2> inSpace(fanCount());
        onFans([&](std::size_t fan) { inSpace[fan] = inSpaceOf(tensors_[fan], frames_[fan]); });
        return inSpace;
    }
    void takeTensors(const std::vector<SpaceTensor2>& inSpace) {
        onFans([&](std::size_t fan) { tensors_[fan] = inFrame(inSpace[fan], frames_[fan]); });
    }

    [[nodiscard]] std::vector<SpaceTensor3> derivativesInSpace() const {
        std::vector<SpaceTensor3> inSpace(fanCount());
        onFans([&](std::size_t fan) { inSpace[fan] = inSpaceOf(derivatives_[fan], frames_[fan]); });
        return inSpace;
    }
    void takeDerivatives(const std::vector<SpaceTensor3>& inSpace) {
        onFans([&](std::size_t fan) { derivatives_[fan] = inFrame(inSpace[fan], frames_[fan]); });
    }

    // One-sided fans bend as their neighbours do that are not.
    void fillOneSided(std::vector<SpaceTensor2>& tensors) const {
        const std::vector<SpaceTensor2> before = tensors;
        onFans([&](std::size_t fan) {
            if (oneSided_[fan] == 0) return;
            std::array<float, 6> sum{};
            float count = 0.0F;
            for (std::uint32_t i = begins_[fan]; i < begins_[fan + 1]; ++i) {
                const std::uint32_t c = corners_[i];
                for (const std::uint32_t other : {nextHalfEdge(c), previousHalfEdge(c)}) {
                    if (oneSided_[form_.fans[other]] != 0) continue;
                    for (std::size_t k = 0; k < 6; ++k) sum[k] += before[form_.fans[other]][k];
                    count += 1.0F;
                }
            }
            if (count == 0.0F) return;
            for (std::size_t k = 0; k < 6; ++k) tensors[fan][k] = sum[k] / count;
        });
    }

    // Turns everything into the principal directions.
    void takePoints() {
        form_.points.resize(fanCount());
        onFans([&](std::size_t fan) {
            const Frame& frame = frames_[fan];
            const Tensor2& t = tensors_[fan];
            const double angle = 0.5 * std::atan2(2.0 * t[1], t[0] - t[2]);
            const glm::dvec2 first{std::cos(angle), std::sin(angle)};
            const glm::dvec2 second{-first.y, first.x};
            PointForm& point = form_.points[fan];
            point.normal = glm::vec3{frame.normal};
            point.first = glm::vec3{first.x * frame.u + first.y * frame.v};
            point.curvatures = {static_cast<float>(along(t, first, first)),
                                static_cast<float>(along(t, second, second))};
            const Tensor3& d = derivatives_[fan];
            point.derivative = {static_cast<float>(along(d, first, first, first)),
                                static_cast<float>(along(d, first, first, second)),
                                static_cast<float>(along(d, first, second, second)),
                                static_cast<float>(along(d, second, second, second))};
        });
    }

    const Mesh& mesh_;
    const MeshTopology& topology_;
    SurfaceForm form_;
    std::vector<double> units_;           // one per patch: 1 / the feature size, or 0
    double coarseness_ = 0.0;             // mean square of an edge's length in resolutions
    std::vector<std::uint32_t> begins_;   // one per fan, and the end: into corners_
    std::vector<std::uint32_t> corners_;  // sorted by fans
    std::vector<std::array<float, 3>> normals_;
    std::vector<std::uint8_t> oneSided_;
    std::vector<Frame> frames_;
    std::vector<Tensor2> tensors_;
    std::vector<Tensor3> derivatives_;
};

}  // namespace

SurfaceForm surfaceForm(const Mesh& mesh, const MeshTopology& topology, double featureSize) {
    if (mesh.indices.empty()) return {};
    return FormBuilder{mesh, topology}.build(featureSize);
}

}  // namespace inkedge::mesh
