#pragma once

#include <limits>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace inkedge::cli {

constexpr double unlimited = std::numeric_limits<double>::max();

/// Refuses what is no number, or is out of range; unlimited stands for no upper limit.
[[nodiscard]] CLI::Validator numberFrom(double low, double high);
/// The same, but refuses the number low, too.
[[nodiscard]] CLI::Validator numberOver(double low, double high);

/// Refuses what is none of these.
[[nodiscard]] CLI::Validator oneOf(std::vector<std::string> names);

}  // namespace inkedge::cli
