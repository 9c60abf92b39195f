#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "lines/find/face_pair.h"
#include "lines/find/face_tree.h"

namespace inkedge::lines {

/// Two sides and the pairs of nodes in which their faces may cross.
class TreePair {
public:
    /// One mesh against itself.
    TreePair(const FaceSide& side, double tolerance) : TreePair{side, side, tolerance} {}

    /// @param a, b       must outlive this; each has faces
    /// @param tolerance  in the space in which both are compared
    TreePair(const FaceSide& a, const FaceSide& b, double tolerance);

    /// Two nodes, one of each side.
    struct Task {
        std::uint32_t first;
        std::uint32_t second;
    };

    /// Splits the work into tasks of about the same size, the same ones whatever the machine.
    [[nodiscard]] std::vector<Task> tasks() const;

    /// The crossings of a task; if there are very many some are left out.
    [[nodiscard]] std::vector<FaceCrossing> find(Task) const;

private:
    struct Search {
        std::uint64_t stepsLeft;
        std::vector<FaceCrossing> found;
    };
    // The box of a node in the space of the other side's boxes.
    struct NodeBox {
        glm::vec3 low;
        glm::vec3 high;
        glm::vec3 axis;
    };

    template <class Take>
    void expand(Task, Take&&) const;
    [[nodiscard]] NodeBox boxInA(const FaceTree::Node& ofB) const;
    [[nodiscard]] bool apart(const FaceTree::Node& a, const FaceTree::Node& b) const;
    void visit(Task, Search&) const;
    void compareLeaves(Task, Search&) const;
    void compareFaces(const FaceTree::Node& a, const FaceTree::Node& b, Search&) const;
    void compare(const SideFace& first, const SideFace& second, Search&) const;
    [[nodiscard]] bool shareAPoint(std::uint32_t first, std::uint32_t second) const;
    [[nodiscard]] bool partAlongAxes(std::uint32_t first, std::uint32_t second) const;

    const FaceSide& a_;
    const FaceSide& b_;
    FacePair faces_;
    bool sameMesh_;
    glm::mat3 toA_{1.0F};
    glm::vec3 offset_{0.0F};
    glm::mat3 absolute_{1.0F};
    float scale_ = 1.0F;
    float margin_ = 0.0F;
};

}  // namespace inkedge::lines
