#pragma once

#include <pybind11/pybind11.h>

#include <inkedge/lines.h>
#include <inkedge/settings.h>

namespace inkedge::python {

/// Lines that were found, and what they were asked for with.
struct DrawnLines {
    Lines lines;
    Settings settings;
    pybind11::dict arrays;  ///< attributes, by their names
};

[[nodiscard]] DrawnLines drawnLines(Lines&&, const Settings&);

void addLines(pybind11::module_&);

}  // namespace inkedge::python
