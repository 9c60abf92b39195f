#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace inkedge::cli {

/// Adds the argument MODEL, whose help names every format that is read.
void addModel(CLI::App& verb, std::string& model);
/// The same for one or more.
void addModels(CLI::App& verb, std::vector<std::string>& models);

}  // namespace inkedge::cli
