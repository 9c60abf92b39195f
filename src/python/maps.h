#pragma once

#include <pybind11/pybind11.h>

#include <inkedge/maps.h>

namespace inkedge::python {

/// What was drawn: a mapping of names to arrays, each of which holds its own map alone, and what is known besides.
struct DrawnMaps {
    pybind11::dict arrays;
    Maps rest;  ///< without its images
    Size size;
};

/// @param writable  whether the arrays may be written to
[[nodiscard]] DrawnMaps drawnMaps(Maps&&, const std::vector<Map>&, bool writable);

void addMaps(pybind11::module_&);

/// Stages and their milliseconds.
[[nodiscard]] pybind11::dict dictOf(const std::vector<StageTime>&);
/// Texts of a file, some of which may be no UTF-8.
[[nodiscard]] pybind11::list listOf(const std::vector<std::string>&);

}  // namespace inkedge::python
