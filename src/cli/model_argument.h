#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace inkedge::cli {

/// Adds the argument MODEL, whose help names every format that is read.
void addModel(CLI::App& verb, std::string& model);

}  // namespace inkedge::cli
