#pragma once

#include <span>
#include <string>

#include "cli/command_line.h"

namespace inkedge::cli {

/// The manual page in the macros of man(7).
/// @param summary  of the command, one line
[[nodiscard]] std::string manualPage(std::string_view summary, std::span<const VerbText>);

}  // namespace inkedge::cli
