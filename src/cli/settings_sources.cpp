#include "cli/settings_sources.h"

#include <cstdlib>
#include <set>
#include <utility>

#include <unistd.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>

namespace inkedge::cli {
namespace {

std::string environmentName(std::string_view setting) {
    std::string name = "INKEDGE_";
    for (const char c : setting)
        name += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
}

// The variables that set a setting; the first is overridden by the second.
std::vector<std::string> variablesOf(const SettingDescription& row) {
    if (row.shortName.empty()) return {environmentName(row.name)};
    return {environmentName(row.shortName), environmentName(row.name)};
}

std::string helpFor(const SettingDescription& row) {
    const std::string byDefault = row.defaultValue();
    return byDefault.empty() ? std::string{row.help} : fmt::format("{} [{}]", row.help, byDefault);
}

std::string presetHelp() {
    std::string help = "start from a named set of settings, which the others override";
    for (const Preset& preset : presets()) help += fmt::format("; {}: {}", preset.name, preset.help);
    return help;
}

}  // namespace

void SettingsSources::addTo(CLI::App& app, const std::function<bool(const SettingDescription&)>& uses) {
    std::vector<std::string_view> presetNames;
    for (const Preset& preset : presets()) presetNames.push_back(preset.name);
    app.add_option("--preset", preset_, presetHelp())->type_name(fmt::format("{}", fmt::join(presetNames, "|")));
    app.add_option("--config", configFile_, "read settings from a file of lines: name = value")->type_name("FILE");
    for (const SettingDescription& row : settingTable()) {
        if (uses && !uses(row)) continue;
        std::string names = fmt::format("--{}", row.name);
        if (!row.shortName.empty()) names += fmt::format(",--{}", row.shortName);
        options_[row.name] = app.add_option(names, flags_[row.name], helpFor(row))
                                 ->type_name(row.values())
                                 ->group(std::string{row.group});
        if (row.joinedBy != '\0') options_[row.name]->join(row.joinedBy);
    }
}

std::vector<std::string> SettingsSources::unknownVariables() {
    std::set<std::string> known;
    for (const SettingDescription& row : settingTable())
        for (std::string& variable : variablesOf(row)) known.insert(std::move(variable));
    std::vector<std::string> unknown;
    for (char** variable = environ; variable != nullptr && *variable != nullptr; ++variable) {
        const std::string_view text{*variable};
        std::string name{text.substr(0, text.find('='))};
        if (name.starts_with("INKEDGE_") && !known.contains(name)) unknown.push_back(std::move(name));
    }
    return unknown;
}

std::vector<std::string_view> SettingsSources::flagsGiven() const {
    std::vector<std::string_view> names;
    for (const auto& [name, option] : options_)
        if (option->count() > 0) names.push_back(name);
    return names;
}

Settings SettingsSources::resolve() const {
    Settings settings;
    if (!preset_.empty()) setPreset(settings, preset_, "--preset");
    if (!configFile_.empty()) readConfig(settings, configFile_);
    for (const SettingDescription& row : settingTable()) {
        for (const std::string& variable : variablesOf(row)) {
            if (const char* text = std::getenv(variable.c_str())) set(settings, row.name, text, variable);
        }
    }
    for (const auto& [name, option] : options_) {
        if (option->count() > 0) set(settings, name, flags_.at(name), fmt::format("--{}", name));
    }
    return settings;
}

}  // namespace inkedge::cli
