#pragma once

#include <vector>

namespace inkedge::sheet {

/// The scales of ISO 5455, 1:1, 1:2, 1:5, 1:10 and so on, and 2:1, 5:1, 10:1, paper : model, the largest first. They
/// go as far as the standard lets them, by powers of ten.
[[nodiscard]] const std::vector<double>& standardScales();

}  // namespace inkedge::sheet
