#include "lines/find/face_tree.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/z_order.h"

namespace inkedge::lines {
namespace {

class Builder {
public:
    Builder(const Mesh& mesh, const mesh::MeshTopology& topology, double maxAngle)
        : mesh_{mesh}, topology_{topology}, widest_{static_cast<float>(maxAngle)} {}

    FaceTree build() {
        tree_.normals = mesh::makeFaceNormals(mesh_, topology_);
        fillPoints();
        sortFaces();
        if (!keys_.empty()) {
            tree_.nodes.reserve(keys_.size());
            addNode(0, static_cast<std::uint32_t>(keys_.size()));
        }
        return std::move(tree_);
    }

private:
    void fillPoints() {
        tree_.points.resize(topology_.pointCount);
        for (std::size_t c = topology_.points.size();
             c-- > 0;)  // the last assignment is that of a point's first corner
            tree_.points[topology_.points[c]] = mesh_.positions[mesh_.indices[c]];
    }

    [[nodiscard]] std::array<glm::vec3, 3> corners(std::uint32_t t) const {
        const std::uint32_t* const p = &topology_.points[3 * std::size_t{t}];
        return {tree_.points[p[0]], tree_.points[p[1]], tree_.points[p[2]]};
    }

    void sortFaces() {
        glm::vec3 low{tree_.points.empty() ? glm::vec3{0.0F} : tree_.points.front()};
        glm::vec3 high = low;
        for (const glm::vec3& p : tree_.points) low = glm::min(low, p), high = glm::max(high, p);
        const mesh::ZOrder order{low, high};
        const auto count = static_cast<std::uint32_t>(topology_.originals.size());
        keys_.reserve(count);
        for (std::uint32_t t = 0; t < count; ++t) {
            if (topology_.originals[t] != t || tree_.normals[t] == glm::dvec3{0.0}) continue;
            const auto [a, b, c] = corners(t);
            keys_.push_back({order.key((glm::dvec3{a} + glm::dvec3{b} + glm::dvec3{c}) / 3.0), t});
        }
        sortByKey(keys_);
        tree_.triangles.reserve(keys_.size());
        for (const mesh::ZOrderKey& each : keys_) tree_.triangles.push_back(each.index);
    }

    // The first key of a range that has the highest bit in which the keys differ.
    [[nodiscard]] std::uint32_t splitOf(std::uint32_t begin, std::uint32_t end) const {
        const std::uint64_t differing = keys_[begin].key ^ keys_[end - 1].key;
        if (differing == 0) return (begin + end) / 2;
        const std::uint64_t bit = std::bit_floor(differing);
        const auto one = std::partition_point(keys_.begin() + begin, keys_.begin() + end,
                                              [&](const mesh::ZOrderKey& k) { return (k.key & bit) == 0; });
        return static_cast<std::uint32_t>(one - keys_.begin());
    }

    std::uint32_t addNode(std::uint32_t begin, std::uint32_t end) {
        const auto number = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.emplace_back();
        FaceTree::Node node{};
        if (end - begin <= FaceTree::leafSize) {
            node = leaf(begin, end);
        } else {
            const std::uint32_t middle = splitOf(begin, end);
            const std::uint32_t first = addNode(begin, middle);
            const std::uint32_t second = addNode(middle, end);
            node = joined(tree_.nodes[first], tree_.nodes[second]);
            node.second = second;
        }
        node.begin = begin;
        node.end = end;
        tree_.nodes[number] = node;
        return number;
    }

    [[nodiscard]] FaceTree::Node leaf(std::uint32_t begin, std::uint32_t end) const {
        FaceTree::Node node{};
        node.low = node.high = corners(tree_.triangles[begin])[0];
        const glm::dvec3 first = tree_.normals[tree_.triangles[begin]];
        glm::dvec3 sum{0.0};
        for (std::uint32_t i = begin; i < end; ++i) {
            for (const glm::vec3& p : corners(tree_.triangles[i])) {
                node.low = glm::min(node.low, p);
                node.high = glm::max(node.high, p);
            }
            const glm::dvec3 normal = tree_.normals[tree_.triangles[i]];
            sum += glm::dot(normal, first) < 0.0 ? -normal : normal;
        }
        const glm::dvec3 axis = glm::normalize(sum);  // every term was turned to the side of the first
        double cosine = 1.0;
        for (std::uint32_t i = begin; i < end; ++i)
            cosine = std::min(cosine, std::abs(glm::dot(tree_.normals[tree_.triangles[i]], axis)));
        node.axis = glm::vec3{axis};
        setAngle(node, static_cast<float>(std::acos(cosine)) + rounding);
        return node;
    }

    [[nodiscard]] FaceTree::Node joined(const FaceTree::Node& a, const FaceTree::Node& b) const {
        FaceTree::Node node{};
        node.low = glm::min(a.low, b.low);
        node.high = glm::max(a.high, b.high);
        node.axis = a.axis;
        node.angle = FaceTree::wideCone;
        if (a.angle > widest_ || b.angle > widest_) return node;
        const glm::vec3 other = glm::dot(a.axis, b.axis) < 0.0F ? -b.axis : b.axis;
        node.axis = glm::normalize(a.axis + other);
        const auto reach = [&](glm::vec3 axis, float angle) {
            return std::acos(std::min(glm::dot(node.axis, axis), 1.0F)) + angle;
        };
        setAngle(node, std::max(reach(a.axis, a.angle), reach(other, b.angle)) + rounding);
        return node;
    }

    void setAngle(FaceTree::Node& node, float angle) const {
        node.angle = angle <= widest_ ? angle : FaceTree::wideCone;
    }

    static constexpr float rounding = 5e-4F;  // radians: the error of acos() of a float near 1

    const Mesh& mesh_;
    const mesh::MeshTopology& topology_;
    float widest_;
    FaceTree tree_;
    std::vector<mesh::ZOrderKey> keys_;
};

}  // namespace

FaceTree buildFaceTree(const Mesh& mesh, const mesh::MeshTopology& topology, double maxAngle) {
    return Builder{mesh, topology, maxAngle}.build();
}

}  // namespace inkedge::lines
