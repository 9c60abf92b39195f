#include "lines/find/tree_pair.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace inkedge::lines {
namespace {

// Only a mass of faces that overlap each other needs more than these.
constexpr std::uint64_t maxSteps = 50'000'000;  // pairs of nodes or faces that a task looks at
constexpr std::size_t maxSegmentsOfTask = 500'000;

}  // namespace

TreePair::TreePair(const FaceSide& a, const FaceSide& b, double tolerance)
    : a_{a}, b_{b}, faces_{a, b, tolerance}, sameMesh_{&a == &b} {
    const glm::dmat4 toA = sameMesh_ ? glm::dmat4{1.0} : glm::inverse(a.transform) * b.transform;
    toA_ = glm::mat3{glm::dmat3{toA}};
    offset_ = glm::vec3{toA[3]};
    for (int i = 0; i < 3; ++i) absolute_[i] = glm::abs(toA_[i]);
    scale_ = static_cast<float>(glm::length(glm::dvec3{toA[0]}));
    // Boxes of floats, transformed by floats: the error is a few roundings of the largest number that occurs.
    const FaceTree::Node& rootOfA = a.tree->nodes.front();
    const FaceTree::Node& rootOfB = b.tree->nodes.front();
    const double reach =
        glm::length(glm::dvec3{offset_}) + glm::length(glm::dvec3{rootOfA.high - rootOfA.low}) +
        double{scale_} * glm::length(glm::dvec3{glm::max(glm::abs(rootOfB.low), glm::abs(rootOfB.high))});
    const double scaleOfA = glm::length(glm::dvec3{a.transform[0]});
    margin_ = static_cast<float>(tolerance / scaleOfA + (sameMesh_ ? 0.0 : 1e-6 * reach));
}

std::vector<TreePair::Task> TreePair::tasks() const {
    std::vector<Task> tasks{{0, 0}};
    const std::size_t wanted =
        std::min<std::size_t>(256, (a_.tree->triangles.size() + b_.tree->triangles.size()) / 4096);
    std::vector<Task> split;
    for (std::size_t before = 0; tasks.size() < wanted && tasks.size() != before;) {
        before = tasks.size();
        split.clear();
        for (const Task& task : tasks) expand(task, [&](Task part) { split.push_back(part); });
        tasks.swap(split);
    }
    return tasks;
}

std::vector<FaceCrossing> TreePair::find(Task task) const {
    Search search{maxSteps, {}};
    visit(task, search);
    return std::move(search.found);
}

// The smaller tasks of a task that may hold a crossing; the task itself if it is small enough to be looked at.
template <class Take>
void TreePair::expand(Task task, Take&& take) const {
    const FaceTree::Node& a = a_.tree->nodes[task.first];
    const FaceTree::Node& b = b_.tree->nodes[task.second];
    if (sameMesh_ && task.first == task.second) {
        if (2.0F * a.angle < static_cast<float>(minCrossingAngle)) return;
        if (a.second == 0) return take(task);
        take({task.first + 1, task.first + 1});
        take({a.second, a.second});
        return take({task.first + 1, a.second});
    }
    if (apart(a, b)) return;
    if (a.second == 0 && b.second == 0) return take(task);
    if (b.second == 0 || (a.second != 0 && a.end - a.begin >= b.end - b.begin)) {
        take({task.first + 1, task.second});
        take({a.second, task.second});
    } else {
        take({task.first, task.second + 1});
        take({task.first, b.second});
    }
}

TreePair::NodeBox TreePair::boxInA(const FaceTree::Node& b) const {
    if (sameMesh_) return {b.low, b.high, b.axis};
    const glm::vec3 centre = toA_ * (0.5F * (b.low + b.high)) + offset_;
    const glm::vec3 half = absolute_ * (0.5F * (b.high - b.low));
    return {centre - half, centre + half, toA_ * b.axis / scale_};
}

// Whether no face of one node can cross a face of the other: their boxes do not overlap, or all faces are nearly
// parallel.
bool TreePair::apart(const FaceTree::Node& a, const FaceTree::Node& nodeOfB) const {
    const NodeBox b = boxInA(nodeOfB);
    if (a.low.x > b.high.x + margin_ || b.low.x > a.high.x + margin_ || a.low.y > b.high.y + margin_ ||
        b.low.y > a.high.y + margin_ || a.low.z > b.high.z + margin_ || b.low.z > a.high.z + margin_)
        return true;
    const float left = static_cast<float>(minCrossingAngle) - a.angle - nodeOfB.angle - 1e-3F;
    if (left <= 0.0F) return false;
    const float square = left * left;
    return std::abs(glm::dot(a.axis, b.axis)) > 1.0F - square * (0.5F - square / 24.0F);  // over the cosine of left
}

void TreePair::visit(Task task, Search& search) const {
    if (search.stepsLeft == 0) return;
    --search.stepsLeft;
    expand(task, [&](Task part) {
        if (part.first == task.first && part.second == task.second)
            compareLeaves(part, search);
        else
            visit(part, search);
    });
}

void TreePair::compareLeaves(Task task, Search& search) const {
    const FaceTree::Node& a = a_.tree->nodes[task.first];
    const FaceTree::Node& b = b_.tree->nodes[task.second];
    search.stepsLeft -= std::min<std::uint64_t>(search.stepsLeft, (a.end - a.begin) * (b.end - b.begin));
    if (!sameMesh_) return compareFaces(a, b, search);
    const bool sameLeaf = task.first == task.second;
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
        for (std::uint32_t j = sameLeaf ? i + 1 : b.begin; j < b.end; ++j) {
            const auto [first, second] = std::minmax(a_.tree->triangles[i], a_.tree->triangles[j]);
            if (shareAPoint(first, second) || partAlongAxes(first, second)) continue;
            const double cosine = glm::dot(a_.tree->normals[first], a_.tree->normals[second]);
            if (std::abs(cosine) < maxCrossingCosine) compare(faceOf(a_, first), faceOf(a_, second), search);
        }
    }
}

void TreePair::compareFaces(const FaceTree::Node& a, const FaceTree::Node& b, Search& search) const {
    std::array<SideFace, FaceTree::leafSize> facesOfB;
    for (std::uint32_t j = b.begin; j < b.end; ++j) facesOfB[j - b.begin] = faceOf(b_, b_.tree->triangles[j]);
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
        const SideFace faceOfA = faceOf(a_, a_.tree->triangles[i]);
        for (std::uint32_t j = b.begin; j < b.end; ++j) compare(faceOfA, facesOfB[j - b.begin], search);
    }
}

void TreePair::compare(const SideFace& first, const SideFace& second, Search& search) const {
    const std::optional<FaceCrossing> found = faces_.cross(first, second);
    if (!found) return;
    if (search.found.size() < maxSegmentsOfTask)
        search.found.push_back(*found);
    else
        search.stepsLeft = 0;
}

bool TreePair::shareAPoint(std::uint32_t first, std::uint32_t second) const {
    const std::uint32_t* const p = &a_.topology->points[3 * std::size_t{first}];
    const std::uint32_t* const q = &a_.topology->points[3 * std::size_t{second}];
    const auto isOneOfQ = [&](std::uint32_t point) { return point == q[0] || point == q[1] || point == q[2]; };
    return isOneOfQ(p[0]) || isOneOfQ(p[1]) || isOneOfQ(p[2]);
}

bool TreePair::partAlongAxes(std::uint32_t first, std::uint32_t second) const {
    const std::uint32_t* const p = &a_.topology->points[3 * std::size_t{first}];
    const std::uint32_t* const q = &a_.topology->points[3 * std::size_t{second}];
    const std::vector<glm::vec3>& points = a_.tree->points;
    const glm::vec3 lowOfP = glm::min(glm::min(points[p[0]], points[p[1]]), points[p[2]]);
    const glm::vec3 highOfP = glm::max(glm::max(points[p[0]], points[p[1]]), points[p[2]]);
    const glm::vec3 lowOfQ = glm::min(glm::min(points[q[0]], points[q[1]]), points[q[2]]);
    const glm::vec3 highOfQ = glm::max(glm::max(points[q[0]], points[q[1]]), points[q[2]]);
    return lowOfP.x > highOfQ.x + margin_ || lowOfQ.x > highOfP.x + margin_ || lowOfP.y > highOfQ.y + margin_ ||
           lowOfQ.y > highOfP.y + margin_ || lowOfP.z > highOfQ.z + margin_ || lowOfQ.z > highOfP.z + margin_;
}

}  // namespace inkedge::lines
