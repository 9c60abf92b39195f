#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

#include <inkedge/setting_table.h>

namespace inkedge::cli {

/// The sources of settings on the command line: --preset, --config, the environment and one flag per setting.
class SettingsSources {
public:
    /// Adds the flags, from the table of settings.
    /// @param uses  whether the verb uses a setting; none: it uses all
    void addTo(CLI::App&, const std::function<bool(const SettingDescription&)>& uses = {});

    /// The settings. A flag overrides the environment, that a configuration file, that a preset, that the default.
    /// @throws Error  (Kind::Usage) if a source has an unknown name or a wrong value: the message names the source;
    ///                (Kind::Input) if the configuration file cannot be read
    [[nodiscard]] Settings resolve() const;

    /// Variables of the environment that begin as those of settings do, and are none's.
    [[nodiscard]] static std::vector<std::string> unknownVariables();

    /// The settings that have a flag on the command line, by their names.
    [[nodiscard]] std::vector<std::string_view> flagsGiven() const;

    /// Empty if none is given.
    [[nodiscard]] const std::string& configFile() const noexcept { return configFile_; }

private:
    std::map<std::string_view, std::string> flags_;  // by setting name; only those that were given count
    std::map<std::string_view, CLI::Option*> options_;
    std::string preset_;
    std::string configFile_;
};

}  // namespace inkedge::cli
