#pragma once

#include <pybind11/pybind11.h>

namespace inkedge::python {

void addScenes(pybind11::module_&);

}  // namespace inkedge::python
