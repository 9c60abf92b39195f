#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

/// What the command line takes, as completions of shells and the manual page are made of it.
namespace inkedge::cli {

struct OptionText {
    std::vector<std::string> names;   ///< with their dashes: "-o", "--output"; of what has none "MODEL"
    std::string form;                 ///< what the value looks like: "PX", "sobel|farid", "FILE"; empty: a flag
    std::string help;                 ///< one line
    std::string group;                ///< heading; empty: none
    std::vector<std::string> values;  ///< all that it takes, or some where others may be thought of
    bool list = false;                ///< it takes several of values, with commas between them
    bool repeats = false;             ///< a positional that takes any number

    /// The long name, if it has one.
    [[nodiscard]] const std::string& name() const;

    [[nodiscard]] bool isPositional() const { return !names.front().starts_with('-'); }
    [[nodiscard]] bool takesFile() const { return form == "FILE" || (isPositional() && values.empty()); }
};

struct VerbText {
    std::string name;
    std::string help;
    std::vector<OptionText> options;  ///< in the order of the help
};

[[nodiscard]] std::vector<VerbText> verbsOf(const CLI::App&);

}  // namespace inkedge::cli
