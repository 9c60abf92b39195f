#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <span>
#include <unordered_map>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "formats/polygons/corner_tree.h"

namespace inkedge::load {

/// Cuts polygons into triangles, those of one file after each other.
///
/// A polygon of n corners gives n - 2 triangles, wound as it is, that use all its corners: where corners lie on a line,
/// some have no area, which keeps the polygon's edges whole. A quad is cut from its first corner, as modelling
/// programs show it, or, if it is concave, from its hollow corner. Larger polygons may be concave and bent; one that
/// crosses itself is cut somehow.
class PolygonCutter {
public:
    using Triangle = std::array<std::uint32_t, 3>;  ///< into the polygon's corners

    /// @param corners  at least three
    /// @return         valid until the next call
    /// @throws Error   (Kind::Input) if the file's polygons together take over some seconds
    [[nodiscard]] std::span<const Triangle> cut(std::span<const glm::dvec3> corners);

private:
    void cutQuad(std::span<const glm::dvec3> corners);
    void cutPolygon(std::span<const glm::dvec3> corners);
    void flatten(std::span<const glm::dvec3> corners);
    void cutOff(std::uint32_t ear);
    void spend(std::uint64_t steps);
    [[nodiscard]] double area(std::uint32_t corner) const;
    [[nodiscard]] bool isEar(std::uint32_t corner);
    [[nodiscard]] std::uint32_t leastBadEar(std::uint32_t corner);
    [[nodiscard]] std::uint32_t nextEar(std::uint32_t corner);

    std::vector<Triangle> triangles_;
    std::vector<glm::dvec2> flat_;  // the corners, seen so that the polygon runs anticlockwise
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint32_t> next_;
    CornerTree hollow_;                   // corners that may lie in an ear: not convex when the polygon was whole
    std::set<std::uint32_t> candidates_;  // corners that may be ears
    std::unordered_multimap<std::uint32_t, std::uint32_t> waiting_;  // by what lay in their triangle
    std::vector<bool> gone_;
    std::uint64_t stepsLeft_ = 200'000'000;
};

}  // namespace inkedge::load
