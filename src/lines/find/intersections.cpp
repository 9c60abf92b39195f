#include "lines/find/intersections.h"

#include <algorithm>
#include <optional>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "base/parallel.h"
#include "lines/find/face_cones.h"
#include "lines/find/face_pair.h"
#include "lines/find/face_tree.h"
#include "lines/find/file_faces.h"
#include "lines/find/tree_pair.h"
#include "mesh/topology.h"
#include "mesh/weld.h"
#include "scene/box_tree.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

constexpr std::size_t maxSegments = 10'000'000;

double lengthOfDiagonal(const Box& box) { return box.empty() ? 0.0 : glm::length(box.max - box.min); }

// The crossings of two sides, sorted, with their ends numbered.
struct SideCrossings {
    std::vector<FaceCrossing> segments;
    std::vector<std::uint32_t> nodes;  // two per segment
    std::uint32_t nodeCount = 0;
};

// @param tolerance  ends that are nearer to each other are one
void numberEnds(SideCrossings& crossing, double tolerance) {
    if (crossing.segments.empty()) return;
    const glm::dvec3 origin = crossing.segments.front().ends[0];
    std::vector<glm::vec3> points;
    points.reserve(2 * crossing.segments.size() + 1);
    for (const FaceCrossing& found : crossing.segments)
        for (const glm::dvec3& end : found.ends) points.emplace_back(end - origin);
    // A point so far away that the weld tolerance, which is a share of the box, is the tolerance. No end is there.
    points.emplace_back(glm::vec3{static_cast<float>(tolerance / mesh::weldTolerance)});
    const mesh::Weld weld = mesh::weldByPosition(points);
    crossing.nodes.assign(weld.point.begin(), weld.point.end() - 1);
    crossing.nodeCount = weld.pointCount - 1;
}

class IntersectionFinder {
public:
    IntersectionFinder(const Scene& scene, std::span<const MeshEdges> edges)
        : scene_{scene},
          edges_{edges},
          trees_(edges.size()),
          cones_(edges.size()),
          fileFaces_(edges.size()),
          sides_(edges.size()) {}

    std::vector<IntersectionSegment> find() {
        findSides();
        findWithinMeshes();
        for (std::uint32_t i = 0; i < scene_.instances().size(); ++i) instances_.push_back(sideOfInstance(i));
        findBetweenInstances();
        return collect();
    }

private:
    struct InstancePair {
        std::uint32_t a;
        std::uint32_t b;
    };

    [[nodiscard]] static bool isFlat(const glm::dmat4& transform) {
        return glm::determinant(glm::dmat3{transform}) == 0.0;
    }

    void findSides() {
        base::onEach(trees_.size(), [&](std::size_t i) {
            const std::span<const glm::dvec3> normals = edges_[i].faceNormals;
            trees_[i] = buildFaceTree(scene_.meshes()[i], scene::topologyOf(scene_, i));
            cones_[i].emplace(trees_[i], normals, minCrossingDistance);
            fileFaces_[i].emplace(trees_[i], scene_.meshes()[i], scene::topologyOf(scene_, i));
            sides_[i] = {&trees_[i],     &*cones_[i], &*fileFaces_[i], normals, &scene::topologyOf(scene_, i),
                         glm::dmat4{1.0}};
        });
    }

    [[nodiscard]] double toleranceOf(std::uint32_t mesh) const {
        return mesh::weldTolerance * lengthOfDiagonal(scene_.meshBox(mesh));
    }

    void findWithinMeshes() {
        std::vector<TreePair> pairings;
        std::vector<double> tolerances;
        std::vector<std::size_t> meshes;
        for (std::size_t i = 0; i < trees_.size(); ++i) {
            if (trees_[i].boxes.empty()) continue;
            tolerances.push_back(toleranceOf(static_cast<std::uint32_t>(i)));
            pairings.emplace_back(sides_[i], tolerances.back());
            meshes.push_back(i);
        }
        within_.resize(trees_.size());
        std::vector<SideCrossings> found = run(pairings, tolerances);
        for (std::size_t i = 0; i < meshes.size(); ++i) within_[meshes[i]] = std::move(found[i]);
    }

    [[nodiscard]] FaceSide sideOfInstance(std::uint32_t i) const {
        const Instance& instance = scene_.instances()[i];
        FaceSide side = sides_[instance.mesh];
        side.transform = instance.transform;
        side.transform[3] += side.transform * glm::dvec4{scene_.meshes()[instance.mesh].origin, 0.0} -
                             glm::dvec4{scene_.bounds().centre, 0.0};
        return side;
    }

    [[nodiscard]] double toleranceOfInstance(std::uint32_t i) const {
        return toleranceOf(scene_.instances()[i].mesh) * glm::length(glm::dvec3{instances_[i].transform[0]});
    }

    [[nodiscard]] Box boxOfInstance(std::uint32_t i) const {
        const Box& box = scene_.meshBox(scene_.instances()[i].mesh);
        const glm::dmat4& transform = instances_[i].transform;
        const glm::dvec3 centre{transform * glm::dvec4{0.5 * (box.min + box.max), 1.0}};
        const glm::dvec3 half = 0.5 * (box.max - box.min);
        const glm::dvec3 reach = glm::abs(glm::dvec3{transform[0]}) * half.x +
                                 glm::abs(glm::dvec3{transform[1]}) * half.y +
                                 glm::abs(glm::dvec3{transform[2]}) * half.z + toleranceOfInstance(i);
        return {centre - reach, centre + reach};
    }

    void findPairs() {
        std::vector<std::uint32_t> instances;
        std::vector<Box> boxes;
        for (std::uint32_t i = 0; i < instances_.size(); ++i) {
            if (instances_[i].tree->boxes.empty() || isFlat(instances_[i].transform)) continue;
            instances.push_back(i);
            boxes.push_back(boxOfInstance(i));
        }
        const scene::BoxTree tree{boxes};
        std::uint64_t stepsLeft = 100'000'000 + 1000 * std::uint64_t{boxes.size()};
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const std::size_t before = pairs_.size();
            tree.forEachOverlap(boxes[i], stepsLeft, [&](std::uint32_t j, const Box&) {
                if (j > i) pairs_.push_back({instances[i], instances[j]});
            });
            std::sort(pairs_.begin() + static_cast<std::ptrdiff_t>(before), pairs_.end(),
                      [](const InstancePair& x, const InstancePair& y) { return x.b < y.b; });
        }
    }

    void findBetweenInstances() {
        findPairs();
        std::vector<TreePair> pairings;
        std::vector<double> tolerances;
        pairings.reserve(pairs_.size());
        for (const InstancePair& pair : pairs_) {
            tolerances.push_back(std::max(toleranceOfInstance(pair.a), toleranceOfInstance(pair.b)));
            pairings.emplace_back(instances_[pair.a], instances_[pair.b], tolerances.back());
        }
        between_ = run(pairings, tolerances);
    }

    static std::vector<SideCrossings> run(const std::vector<TreePair>& pairings,
                                          const std::vector<double>& tolerances) {
        struct TaskCrossings {
            std::size_t pairing;
            TreePair::Task task;
            std::vector<FaceCrossing> found;
        };
        std::vector<TaskCrossings> parts;
        for (std::size_t i = 0; i < pairings.size(); ++i)
            for (const TreePair::Task& task : pairings[i].tasks()) parts.push_back({i, task, {}});
        base::onEach(parts.size(),
                     [&](std::size_t i) { parts[i].found = pairings[parts[i].pairing].find(parts[i].task); });

        std::vector<SideCrossings> crossings(pairings.size());
        for (TaskCrossings& part : parts) {
            std::vector<FaceCrossing>& segments = crossings[part.pairing].segments;
            segments.insert(segments.end(), part.found.begin(), part.found.end());
            part.found = std::vector<FaceCrossing>{};
        }
        base::onEach(crossings.size(), [&](std::size_t i) {
            std::ranges::sort(crossings[i].segments, {}, [](const FaceCrossing& f) { return std::pair{f.a, f.b}; });
            numberEnds(crossings[i], 2.0 * tolerances[i]);
        });
        return crossings;
    }

    [[nodiscard]] std::vector<IntersectionSegment> collect() const {
        std::vector<IntersectionSegment> segments;
        auto pair = pairs_.begin();
        std::uint32_t firstNode = 0;
        const auto add = [&](const SideCrossings& crossing, InstancePair of, const glm::dmat4& transform) {
            if (segments.size() + crossing.segments.size() > maxSegments) return;
            for (std::size_t i = 0; i < crossing.segments.size(); ++i) {
                const FaceCrossing& found = crossing.segments[i];
                const auto moved = [&](glm::dvec3 end) { return glm::dvec3{transform * glm::dvec4{end, 1.0}}; };
                segments.push_back({{of.a, found.a},
                                    {of.b, found.b},
                                    {moved(found.ends[0]), moved(found.ends[1])},
                                    {firstNode + crossing.nodes[2 * i], firstNode + crossing.nodes[2 * i + 1]}});
            }
            firstNode += crossing.nodeCount;
        };
        for (std::uint32_t i = 0; i < instances_.size(); ++i) {
            if (!isFlat(instances_[i].transform))
                add(within_[scene_.instances()[i].mesh], {i, i}, instances_[i].transform);
            for (; pair != pairs_.end() && pair->a == i; ++pair)
                add(between_[static_cast<std::size_t>(pair - pairs_.begin())], *pair, glm::dmat4{1.0});
        }
        return segments;
    }

    const Scene& scene_;
    std::span<const MeshEdges> edges_;
    std::vector<FaceTree> trees_;
    std::vector<std::optional<FaceCones>> cones_;
    std::vector<std::optional<FileFaces>> fileFaces_;
    std::vector<FaceSide> sides_;        // one per mesh, in its own space less its origin
    std::vector<SideCrossings> within_;  // one per mesh, in its own space less its origin
    std::vector<FaceSide> instances_;    // one per instance, in world space less the scene's middle
    std::vector<InstancePair> pairs_;
    std::vector<SideCrossings> between_;  // one per pair
};

}  // namespace

std::vector<IntersectionSegment> findIntersections(const Scene& scene, std::span<const MeshEdges> edges) {
    return IntersectionFinder{scene, edges}.find();
}

}  // namespace inkedge::lines
