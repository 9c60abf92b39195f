#pragma once

#include <limits>

#include <CLI/CLI.hpp>

namespace inkedge::cli {

constexpr double unlimited = std::numeric_limits<double>::max();

/// Refuses what is no number or lies outside of these; unlimited stands for no upper limit.
[[nodiscard]] CLI::Validator numberFrom(double low, double high);
/// The same without the number low itself.
[[nodiscard]] CLI::Validator numberOver(double low, double high);

}  // namespace inkedge::cli
