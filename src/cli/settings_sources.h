#pragma once

#include <filesystem>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include <inkedge/setting_table.h>

namespace inkedge::cli {

/// Where settings come from on the command line: --preset, --config, the environment and one flag a setting.
class SettingsSources {
public:
    /// Adds the flags, from the one settings table.
    /// @param groups  of settings, those that the verb uses; none given: all
    void addTo(CLI::App&, std::initializer_list<std::string_view> groups = {});

    /// The settings: flag over environment over configuration file over preset over default.
    /// @throws Error  (Kind::Usage) if a source has an unknown name or a wrong value: the message names the source;
    ///                (Kind::Input) if the configuration file cannot be read
    [[nodiscard]] Settings resolve() const;

private:
    std::map<std::string_view, std::string> flags_;  // by setting name; only those given count
    std::map<std::string_view, CLI::Option*> options_;
    std::string preset_;
    std::string configFile_;
};

}  // namespace inkedge::cli
