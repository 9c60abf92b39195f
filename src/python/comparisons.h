#pragma once

#include <pybind11/pybind11.h>

namespace inkedge::python {

/// Comparisons of pictures and lines, and the writing of a picture that is compared.
void addComparisons(pybind11::module_&);

}  // namespace inkedge::python
