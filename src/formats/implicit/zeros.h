#pragma once

#include <utility>
#include <vector>

#include "formats/implicit/scalar_field.h"

namespace inkedge::implicit {

/// The values of a field at some positions, on all cores.
[[nodiscard]] std::vector<double> valuesAt(const ScalarField&, const std::vector<glm::dvec3>& at);

/// From a position at which a field is under 0 to one at which it is not; or both the same.
using Edge = std::pair<glm::dvec3, glm::dvec3>;

/// Where the field is 0 on each edge, to rounding: the Illinois method (Dowell and Jarratt 1971), a step of all edges
/// at once. Of an edge whose ends are the same it is these.
[[nodiscard]] std::vector<glm::dvec3> zerosOn(const ScalarField&, const std::vector<Edge>&);

}  // namespace inkedge::implicit
