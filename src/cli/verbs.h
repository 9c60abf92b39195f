#pragma once

#include <functional>

#include <CLI/CLI.hpp>

namespace inkedge::cli {

/// What the parsed command line asks for: does it and returns the exit code.
using Action = std::function<int()>;

/// Each adds its verb to the command line; parsing it sets the action.
void addRender(CLI::App&, Action&);
void addBatch(CLI::App&, Action&);
void addGallery(CLI::App&, Action&);
void addSheet(CLI::App&, Action&);
void addTune(CLI::App&, Action&);
void addCompare(CLI::App&, Action&);
void addInspect(CLI::App&, Action&);
void addDoctor(CLI::App&, Action&);
void addCompletion(CLI::App&, Action&);
void addManual(CLI::App&, Action&);

}  // namespace inkedge::cli
