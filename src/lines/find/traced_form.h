#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/surface_form.h"
#include "mesh/topology.h"

namespace inkedge::lines {

/// What lines of form are made of: straight across a face, in mesh space less Mesh::origin.
struct FormSegment {
    std::uint32_t triangle;
    std::array<glm::dvec3, 2> ends;
    /// The edges on which the ends lie, named by the smaller of their half-edges; noHalfEdge: the end lies in the face.
    std::array<std::uint32_t, 2> edges;
    std::array<double, 2> strengths;
};

/// A value at a corner, 0 on the line, and how strong a line there would be.
struct FormCorner {
    double value;
    double strength;
    double facing = 1.0;  ///< under 0: on the far side, where there is no line
};

/// The corners of one face.
struct FormFace {
    std::uint32_t triangle;
    std::array<glm::dvec3, 3> positions;
    std::array<std::uint32_t, 3> edges;  ///< from each corner to the next, as FormSegment::edges
};

/// Adds the line through a face, if its values differ in sign, as far as its strength is over a minimum.
void traceThrough(const FormFace&, const std::array<FormCorner, 3>&, double minStrength, std::vector<FormSegment>& to);

/// Leaves the segments of lines that are as strong as a threshold somewhere, and long enough. The order stays.
/// @param minLengths  one per patch
[[nodiscard]] std::vector<FormSegment> strongLines(std::vector<FormSegment>, double threshold,
                                                   std::span<const double> minLengths, const mesh::MeshTopology&);

}  // namespace inkedge::lines
