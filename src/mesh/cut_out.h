#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <inkedge/image.h>
#include <inkedge/mesh.h>

namespace inkedge {

/// Cuts triangles along the outline of what a picture lets be seen of them, so that a cut-out's rim is an edge of the
/// mesh like any other. The outline is where the opacity, interpolated between texel centres, crosses the threshold,
/// simplified to a tenth of a texel.
class CutOut {
public:
    /// @param opacity    one channel, row 0 at the top
    /// @param threshold  there is something where the opacity is at least this, over 0 and at most 255
    CutOut(Image<std::uint8_t> opacity, std::array<TextureWrap, 2> wrap, double threshold);
    ~CutOut();
    CutOut(const CutOut&) = delete;
    CutOut& operator=(const CutOut&) = delete;

    /// Part of a triangle: its corners' weights of the triangle's corners, each 0 to 1, their sum 1.
    using Piece = std::array<glm::dvec3, 3>;

    /// What there is of a triangle. Neighbours that share an edge, and its texture coordinates, are cut at the same
    /// places of it. The pieces are wound as the triangle is.
    /// @param corners  texture coordinates: (0, 0) the picture's top left corner, (1, 1) its bottom right one
    /// @throws Error   (Kind::Input) if the triangle spans too many texels or the outline has too many corners
    [[nodiscard]] std::vector<Piece> cut(const std::array<glm::dvec2, 3>& corners);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace inkedge
