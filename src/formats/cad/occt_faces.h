#pragma once

#include <TopoDS_Face.hxx>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace inkedge::cad {

/// Whether a node lies where all values of a parameter are one point.
enum class Pole : std::uint8_t { None, OfU, OfV };

/// The triangles of a face, wound so that its outward side is their front.
struct MeshedFace {
    TopoDS_Face face;
    std::size_t number = 0;  ///< in its part
    bool turned = false;     ///< the front is against the surface's own normal
    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;     ///< unit, of the surface, towards the front; 0 where it has none
    std::vector<glm::dvec2> parameters;  ///< on the surface
    std::vector<Pole> poles;             ///< what of a node's parameters says nothing
    std::vector<std::array<std::uint32_t, 3>> triangles;

    /// None: the face has no triangles.
    [[nodiscard]] static std::optional<MeshedFace> of(const TopoDS_Face&);

    /// Divides edges whose middle lies farther from the surface than the deflection allows, but for those of the face's
    /// border.
    /// @param isBorder  of two nodes
    void refine(double deflection, const std::function<bool(std::uint32_t, std::uint32_t)>& isBorder);
};

}  // namespace inkedge::cad
