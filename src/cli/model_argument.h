#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include <inkedge/settings.h>

namespace inkedge::cli {

/// A model that the command line names.
struct GivenModel {
    std::filesystem::path name;  ///< its file; from stdin: "stdin", with its format's extension
    std::optional<std::vector<std::uint8_t>> bytes = {};  ///< from stdin; none: the file's

    [[nodiscard]] std::optional<std::span<const std::uint8_t>> content() const noexcept { return bytes; }
};

/// The argument MODEL, whose help names every format that is read, and --format, which says what stdin holds.
class ModelArgument {
public:
    /// One model, which is required.
    void addTo(CLI::App& verb);
    /// Any number of models.
    void addSeveralTo(CLI::App& verb);

    [[nodiscard]] const std::vector<std::string>& names() const noexcept { return names_; }

    /// The models in the order of the command line. Reads stdin to its end if one of them is "-".
    /// @throws Error  (Kind::Usage) if stdin is asked for twice, or --format without it; (Kind::Input) if stdin is a
    ///                terminal or longer than the limit
    [[nodiscard]] std::vector<GivenModel> models(const LoadLimits&) const;

private:
    void addFormatTo(CLI::App& verb);

    std::vector<std::string> names_;
    std::string format_;
};

}  // namespace inkedge::cli
