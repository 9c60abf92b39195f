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
constexpr std::uint64_t stepsOfFour = 16;  // four nodes or faces with four others

constexpr float rounding = 1e-3F;  // of the distance of two normals

struct Extent {
    glm::vec3 low;
    glm::vec3 high;
};
Extent extentOf(const FaceTree& tree) {
    const FourBoxes& boxes = tree.boxes.boxes(tree.boxes.top() - 1, 0);
    Extent all{boxes.min(0), boxes.max(0)};
    for (std::size_t k = 1; k < tree.boxes.count(tree.boxes.top() - 1); ++k) {
        all.low = glm::min(all.low, boxes.min(k));
        all.high = glm::max(all.high, boxes.max(k));
    }
    return all;
}

// Which of b's faces have a point in common with face i of a, as bits: a point has one position.
unsigned touching(const FaceTree::Packet& a, std::size_t i, const FaceTree::Packet& b) {
    FourBits touching{};
    for (const auto& p : a.corners)
        for (const auto& q : b.corners)
            touching |= (four(p[0][i]) == q[0]) & (four(p[1][i]) == q[1]) & (four(p[2][i]) == q[2]);
    return bitsOf(touching);
}

}  // namespace

TreePair::TreePair(const FaceSide& a, const FaceSide& b, double tolerance)
    : a_{a}, b_{b}, faces_{a, b, tolerance}, sameMesh_{&a == &b} {
    const glm::dmat4 toA = sameMesh_ ? glm::dmat4{1.0} : glm::inverse(a.transform) * b.transform;
    toA_ = glm::mat3{glm::dmat3{toA}};
    offset_ = glm::vec3{toA[3]};
    for (int i = 0; i < 3; ++i) absolute_[i] = glm::abs(toA_[i]);
    scale_ = static_cast<float>(glm::length(glm::dvec3{toA[0]}));
    // Boxes of floats, transformed by floats: the error is a few roundings of the largest number that occurs.
    const Extent ofA = extentOf(*a.tree);
    const Extent ofB = extentOf(*b.tree);
    const double reach = glm::length(glm::dvec3{offset_}) + glm::length(glm::dvec3{ofA.high - ofA.low}) +
                         double{scale_} * glm::length(glm::dvec3{glm::max(glm::abs(ofB.low), glm::abs(ofB.high))});
    const double scaleOfA = glm::length(glm::dvec3{a.transform[0]});
    margin_ = static_cast<float>(tolerance / scaleOfA + (sameMesh_ ? 0.0 : 1e-6 * reach));
}

std::vector<TreePair::Task> TreePair::tasks() const {
    std::vector<Task> tasks{{{a_.tree->boxes.top(), 0}, {b_.tree->boxes.top(), 0}}};
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

TreePair::Nodes TreePair::below(const FaceSide& side, Node node) {
    const std::uint32_t level = node.level - 1;
    const std::uint32_t first = 4 * node.index;
    return {level,
            first,
            0,
            std::min(4U, side.tree->boxes.count(level) - first),
            &side.tree->boxes.boxes(level, node.index),
            &side.cones->cones(level, node.index)};
}

TreePair::Nodes TreePair::only(const FaceSide& side, Node packet) {
    const std::uint32_t parent = packet.index / 4;
    const std::uint32_t k = packet.index % 4;
    return {0, 4 * parent, k, k + 1, &side.tree->boxes.boxes(0, parent), &side.cones->cones(0, parent)};
}

// The smaller tasks of a task that may hold a crossing; the task itself if it is of packets.
template <class Take>
void TreePair::expand(Task task, Take&& take) const {
    if (task.first.level == 0 && task.second.level == 0) return take(task);
    const bool self = sameMesh_ && task.first == task.second;
    const Nodes a = task.first.level == 0 ? only(a_, task.first) : below(a_, task.first);
    Nodes b = task.second.level == 0 ? only(b_, task.second) : below(b_, task.second);
    FourBoxes boxesOfB;
    FourCones conesOfB;
    if (!sameMesh_) {
        boxesOfB = inA(*b.boxes);
        conesOfB = inA(*b.cones);
        b.boxes = &boxesOfB;
        b.cones = &conesOfB;
    }
    for (std::uint32_t i = a.begin; i < a.end; ++i) {
        const Node first{a.level, a.first + i};
        const bool isBent = 2.0F * a.cones->radius[i] >= minCrossingDistance - rounding;
        if (self && isBent && mayMeet(first, first)) take({first, first});
        const unsigned near = this->near(*a.boxes, i, *b.boxes);
        const unsigned from = self ? i + 1 : b.begin;
        const unsigned wanted = near & ((1U << b.end) - (1U << from));
        if (wanted == 0) continue;
        const unsigned open = wanted & bent(*a.cones, i, *b.cones);
        for (std::uint32_t j = from; j < b.end; ++j)
            if (const Node second{b.level, b.first + j}; (open >> j & 1U) != 0 && mayMeet(first, second))
                take({first, second});
    }
}

FourBoxes TreePair::inA(const FourBoxes& ofB) const {
    FourBoxes boxes;
    for (std::size_t k = 0; k < 4; ++k) {
        if (ofB.low[0][k] == FourBoxes::none) continue;
        const glm::vec3 centre = toA_ * (0.5F * (ofB.min(k) + ofB.max(k))) + offset_;
        const glm::vec3 half = absolute_ * (0.5F * (ofB.max(k) - ofB.min(k)));
        boxes.set(k, centre - half, centre + half);
    }
    return boxes;
}

FourCones TreePair::inA(const FourCones& ofB) const {
    FourCones cones = ofB;
    for (std::size_t k = 0; k < 4; ++k) {
        const glm::vec3 axis = toA_ * glm::vec3{ofB.axis[0][k], ofB.axis[1][k], ofB.axis[2][k]} / scale_;
        for (int i = 0; i < 3; ++i) cones.axis[i][k] = axis[i];
    }
    return cones;
}

// Which of b's boxes are not apart from box k of a, as bits.
unsigned TreePair::near(const FourBoxes& a, std::size_t k, const FourBoxes& b) const {
    FourBits apart{};
    const Four margin = four(margin_);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        apart |= four(a.low[axis][k]) > b.high[axis] + margin;
        apart |= b.low[axis] > four(a.high[axis][k]) + margin;
    }
    return bitsOf(apart) ^ 15U;
}

// Of which of b's cones some face is not nearly parallel to some face of cone k of a, as bits.
unsigned TreePair::bent(const FourCones& a, std::size_t k, const FourCones& b) const {
    const Four cosine =
        four(a.axis[0][k]) * b.axis[0] + four(a.axis[1][k]) * b.axis[1] + four(a.axis[2][k]) * b.axis[2];
    const Four left = four(minCrossingDistance - rounding - a.radius[k]) - b.radius;
    const Four square = four(2.0F) - four(2.0F) * larger(cosine, -cosine);  // of the distance of two axes
    return bitsOf((left > four(0.0F)) & (square < left * left)) ^ 15U;
}

void TreePair::visit(Task task, Search& search) const {
    if (search.stepsLeft == 0) return;
    search.stepsLeft -= std::min(search.stepsLeft, stepsOfFour);
    if (task.first.level == 0 && task.second.level == 0)
        return comparePackets(task.first.index, task.second.index, search);
    expand(task, [&](Task part) { visit(part, search); });
}

// Whether faces of two nodes may cross by what a CAD file says.
bool TreePair::mayMeet(Node first, Node second) const {
    return !sameMesh_ || !a_.fileFaces->areBeside(first.level, first.index, second.level, second.index);
}

void TreePair::comparePackets(std::uint32_t a, std::uint32_t b, Search& search) const {
    if (sameMesh_) return compareOwnPackets(a, b, search);
    const FourBoxes boxesOfA = a_.tree->packets[a].boxes();
    const FourBoxes boxesOfB = inA(b_.tree->packets[b].boxes());
    const unsigned ends = 1U << b_.tree->facesIn(b);
    std::array<std::optional<SideFace>, 4> ofB;  // those that are compared
    for (std::uint32_t i = 0; i < a_.tree->facesIn(a); ++i) {
        const std::uint32_t first = a_.tree->triangles[4 * std::size_t{a} + i];
        if (a_.normals[first] == glm::dvec3{0.0}) continue;
        const unsigned near = this->near(boxesOfA, i, boxesOfB) & (ends - 1U);
        if (near == 0) continue;
        const SideFace ofA = faceOf(a_, first);
        for (std::uint32_t j = 0; near >> j != 0; ++j) {
            const std::uint32_t second = b_.tree->triangles[4 * std::size_t{b} + j];
            if ((near >> j & 1U) == 0 || b_.normals[second] == glm::dvec3{0.0}) continue;
            if (!ofB[j]) ofB[j] = faceOf(b_, second);
            compare(ofA, *ofB[j], search);
        }
    }
}

// Two packets of one mesh.
void TreePair::compareOwnPackets(std::uint32_t a, std::uint32_t b, Search& search) const {
    const FaceTree::Packet& packetOfA = a_.tree->packets[a];
    const FaceTree::Packet& packetOfB = a_.tree->packets[b];
    const FourBoxes boxesOfA = packetOfA.boxes();
    const FourBoxes boxesOfB = packetOfB.boxes();
    const unsigned ends = 1U << a_.tree->facesIn(b);
    for (std::uint32_t i = 0; i < a_.tree->facesIn(a); ++i) {
        const unsigned begin = a == b ? i + 1 : 0;
        unsigned near = this->near(boxesOfA, i, boxesOfB) & (ends - (1U << begin));
        if (near != 0) near &= ~touching(packetOfA, i, packetOfB);
        for (std::uint32_t j = begin; near >> j != 0; ++j) {
            if ((near >> j & 1U) == 0) continue;
            compareWithin(a_.tree->triangles[4 * std::size_t{a} + i], a_.tree->triangles[4 * std::size_t{b} + j],
                          search);
        }
    }
}

void TreePair::compareWithin(std::uint32_t one, std::uint32_t other, Search& search) const {
    const auto [first, second] = std::minmax(one, other);
    const glm::dvec3 a = a_.normals[first];
    const glm::dvec3 b = a_.normals[second];
    if (a == glm::dvec3{0.0} || b == glm::dvec3{0.0} || std::abs(glm::dot(a, b)) >= maxCrossingCosine) return;
    compare(faceOf(a_, first), faceOf(a_, second), search);
}

void TreePair::compare(const SideFace& first, const SideFace& second, Search& search) const {
    const std::optional<FaceCrossing> found = faces_.cross(first, second);
    if (!found) return;
    if (search.found.size() < maxSegmentsOfTask)
        search.found.push_back(*found);
    else
        search.stepsLeft = 0;
}

}  // namespace inkedge::lines
