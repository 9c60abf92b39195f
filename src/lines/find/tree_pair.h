#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "lines/find/face_cones.h"
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

    /// A node of BoxLevels; of level 0, a packet.
    struct Node {
        std::uint32_t level;
        std::uint32_t index;
        bool operator==(const Node&) const = default;
    };
    /// Two nodes, one of each side.
    struct Task {
        Node first;
        Node second;
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
    // Nodes of one parent, with their boxes and cones: all of them, or one.
    struct Nodes {
        std::uint32_t level;
        std::uint32_t first;  // of the parent's four
        std::uint32_t begin;  // of these the nodes from begin to end
        std::uint32_t end;
        const FourBoxes* boxes;
        const FourCones* cones;
    };

    template <class Take>
    void expand(Task, Take&&) const;
    [[nodiscard]] static Nodes below(const FaceSide&, Node);
    [[nodiscard]] static Nodes only(const FaceSide&, Node packet);
    [[nodiscard]] unsigned near(const FourBoxes& a, std::size_t k, const FourBoxes& bInA) const;
    [[nodiscard]] unsigned bent(const FourCones& a, std::size_t k, const FourCones& bInA) const;
    [[nodiscard]] FourBoxes inA(const FourBoxes& ofB) const;
    [[nodiscard]] FourCones inA(const FourCones& ofB) const;
    void visit(Task, Search&) const;
    [[nodiscard]] bool mayMeet(Node first, Node second) const;
    void comparePackets(std::uint32_t a, std::uint32_t b, Search&) const;
    void compareOwnPackets(std::uint32_t a, std::uint32_t b, Search&) const;
    void compareWithin(std::uint32_t first, std::uint32_t second, Search&) const;
    void compare(const SideFace& first, const SideFace& second, Search&) const;

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
