#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/image.h>
#include <inkedge/mesh.h>

#include "mesh/opaque_part.h"

namespace inkedge::mesh {

/// Cuts triangles along the outline of their picture's opaque area, so that the rim of a cut-out is an edge of the mesh
/// like any other. The outline is where the opacity, interpolated between texel centres, crosses the threshold,
/// simplified to a tenth of a texel.
class CutOut {
public:
    static constexpr int cellSize = 128;  ///< texels: the lattice that triangles and the outline are cut along
    static constexpr std::uint64_t maxCells = 32'768;  ///< of all cut-outs of a model: each takes up to 0.1 ms

    /// @param opacity    one channel, row 0 at the top
    /// @param threshold  the picture is opaque where its opacity is at least this; over 0
    /// @param cellsLeft  how many more cells may be looked at; must outlive this
    CutOut(std::shared_ptr<const Image<std::uint8_t>> opacity, std::array<TextureWrap, 2> wrap, double threshold,
           std::uint64_t& cellsLeft);
    ~CutOut();
    CutOut(const CutOut&) = delete;
    CutOut& operator=(const CutOut&) = delete;

    /// The opaque pieces of a triangle. Two triangles that share an edge with its texture coordinates are cut at the
    /// same points of that edge. The pieces are wound as the triangle is.
    /// @param corners  texture coordinates: (0, 0) the picture's top left corner, (1, 1) its bottom right one
    /// @throws Error   (Kind::Input) if the triangle spans too many texels or the outline has too many corners
    [[nodiscard]] std::vector<TrianglePiece> cut(const std::array<glm::dvec2, 3>& corners);

    /// The same of a triangle in which the picture's opacity is multiplied by factors that change from corner to
    /// corner. The product is sampled at steps of at most a texel. Triangles that share an edge are cut at the same
    /// points of it if all of them are cut so.
    [[nodiscard]] std::vector<TrianglePiece> cut(const std::array<glm::dvec2, 3>& corners, const glm::dvec3& factors);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace inkedge::mesh
