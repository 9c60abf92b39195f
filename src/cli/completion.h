#pragma once

#include <span>
#include <string>

#include "cli/command_line.h"

namespace inkedge::cli {

/// A shell's script that completes verbs, options, their values and names of files.
[[nodiscard]] std::string bashCompletion(std::span<const VerbText>);
[[nodiscard]] std::string zshCompletion(std::span<const VerbText>);
[[nodiscard]] std::string fishCompletion(std::span<const VerbText>);

}  // namespace inkedge::cli
