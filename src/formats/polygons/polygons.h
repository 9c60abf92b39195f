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

namespace inkedge::polygons {

/// Cuts the polygons of one file into triangles, one after the other.
///
/// A polygon of n corners gives n - 2 triangles with the polygon's winding, which use all its corners. Where corners
/// lie on a straight line some triangles have no area, so that the polygon's edges stay whole. A quad is cut from its
/// first corner, as modelling programs show it, or from its reflex corner if it is concave. Larger polygons may be
/// concave and bent; the triangles of one that crosses itself are arbitrary.
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
    [[nodiscard]] std::uint32_t forcedEar(std::uint32_t corner);
    [[nodiscard]] std::uint32_t nextEar(std::uint32_t corner);

    std::vector<Triangle> triangles_;
    std::vector<glm::dvec2> flat_;  // the corners, projected so that the polygon runs anticlockwise
    std::vector<std::uint32_t> previous_;
    std::vector<std::uint32_t> next_;
    CornerTree reflex_;                   // corners that may lie in an ear: not convex when the polygon was whole
    std::set<std::uint32_t> candidates_;  // corners that may be ears
    std::unordered_multimap<std::uint32_t, std::uint32_t>
        waiting_;  // corners, by the corner that lay in their triangle
    std::vector<bool> gone_;
    std::uint64_t stepsLeft_ = 200'000'000;
};

}  // namespace inkedge::polygons
