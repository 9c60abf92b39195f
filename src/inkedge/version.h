#pragma once

#include <string_view>

#include <inkedge/export.h>

namespace inkedge {

/// The version of the library that runs: "0.1.0", MAJOR.MINOR.PATCH. While MAJOR is 0, libraries of another MINOR are
/// not compatible: the shared library's name holds both.
[[nodiscard]] INKEDGE_API std::string_view version() noexcept;

}  // namespace inkedge
