#pragma once

#include <string>

#include <pybind11/pybind11.h>

#include <inkedge/error.h>

namespace inkedge::python {

namespace py = pybind11;

/// Makes the class Error and one of each Error::Kind, which what is thrown becomes; and Warning.
void addErrors(py::module_&);

/// A warning of the line that called. @throws py::error_already_set  where the caller has made warnings errors
void warn(const std::string& message);

/// A text as Python has it: what is no UTF-8, as names in models may hold, becomes U+FFFD.
[[nodiscard]] py::str textOf(const std::string&);

[[noreturn]] void refuse(const std::string& message);

}  // namespace inkedge::python
