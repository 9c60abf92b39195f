#pragma once

#include <gp_Trsf.hxx>
#include <gp_XYZ.hxx>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

namespace inkedge::cad {

[[nodiscard]] inline glm::dvec3 vectorOf(const gp_XYZ& v) { return {v.X(), v.Y(), v.Z()}; }

[[nodiscard]] inline glm::dmat4 matrixOf(const gp_Trsf& trsf) {
    glm::dmat4 matrix{1.0};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 4; ++column) matrix[column][row] = trsf.Value(row + 1, column + 1);
    return matrix;
}

}  // namespace inkedge::cad
