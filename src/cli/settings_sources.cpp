#include "cli/settings_sources.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>

namespace inkedge::cli {
namespace {

std::string environmentName(std::string_view setting) {
    std::string name = "INKEDGE_";
    for (const char c : setting)
        name += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return name;
}

std::string helpFor(const SettingDescription& row) {
    return row.defaultValue.empty() ? std::string{row.help} : fmt::format("{} [{}]", row.help, row.defaultValue);
}

void applyPreset(Settings& settings, std::string_view wanted) {
    const auto found = std::ranges::find(presets(), wanted, &Preset::name);
    if (found == presets().end()) {
        std::vector<std::string_view> names;
        for (const Preset& preset : presets()) names.push_back(preset.name);
        throw Error{Error::Kind::Usage,
                    fmt::format("--preset: expected one of {}, found '{}'", fmt::join(names, ", "), wanted)};
    }
    for (const auto& [name, text] : found->values) set(settings, name, text, fmt::format("preset {}", wanted));
}

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blanks = " \t\r";
    const std::size_t begin = text.find_first_not_of(blanks);
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string_view unquoted(std::string_view text) {
    const bool quoted = text.size() >= 2 && text.front() == '"' && text.back() == '"';
    return quoted ? text.substr(1, text.size() - 2) : text;
}

// Lines name = value; a comment is a line that starts with #, because a colour may start with one too.
void applyConfigFile(Settings& settings, const std::string& file) {
    std::ifstream stream{file};
    stream.peek();  // a folder can be opened but not read
    if (stream.fail() && !stream.eof()) {
        throw Error{Error::Kind::Input,
                    fmt::format("{}: expected a configuration file, found none that can be read", file)};
    }
    int number = 1;
    for (std::string line; std::getline(stream, line); ++number) {
        const std::string_view text = trimmed(line);
        if (text.empty() || text.front() == '#') continue;
        const std::size_t equals = text.find('=');
        if (equals == std::string_view::npos) {
            throw Error{Error::Kind::Usage,
                        fmt::format("{}:{}: expected name = value, found '{}'", file, number, text)};
        }
        const std::string_view name = trimmed(text.substr(0, equals));
        if (std::ranges::find(settingTable(), name, &SettingDescription::name) == settingTable().end()) {
            throw Error{Error::Kind::Usage,
                        fmt::format("{}:{}: expected the name of a setting, found '{}'", file, number, name)};
        }
        set(settings, name, unquoted(trimmed(text.substr(equals + 1))), fmt::format("{}:{}: {}", file, number, name));
    }
}

}  // namespace

void SettingsSources::addTo(CLI::App& app) {
    app.add_option("--preset", preset_, "start from a named set of settings")->type_name("NAME");
    app.add_option("--config", configFile_, "read settings from a file of lines: name = value")->type_name("FILE");
    for (const SettingDescription& row : settingTable()) {
        std::string names = fmt::format("--{}", row.name);
        if (!row.shortName.empty()) names += fmt::format(",--{}", row.shortName);
        options_[row.name] = app.add_option(names, flags_[row.name], helpFor(row))
                                 ->type_name(std::string{row.values})
                                 ->group(std::string{row.group});
    }
}

Settings SettingsSources::resolve() const {
    Settings settings;
    if (!preset_.empty()) applyPreset(settings, preset_);
    if (!configFile_.empty()) applyConfigFile(settings, configFile_);
    for (const SettingDescription& row : settingTable()) {
        const std::string variable = environmentName(row.name);
        if (const char* text = std::getenv(variable.c_str())) set(settings, row.name, text, variable);
    }
    for (const auto& [name, option] : options_) {
        if (option->count() > 0) set(settings, name, flags_.at(name), fmt::format("--{}", name));
    }
    return settings;
}

}  // namespace inkedge::cli
