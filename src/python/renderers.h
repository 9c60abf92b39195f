#pragma once

#include <pybind11/pybind11.h>

namespace inkedge::python {

void addRenderers(pybind11::module_&);

}  // namespace inkedge::python
