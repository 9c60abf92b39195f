#include <inkedge/setting_table.h>

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>

#include "base/message.h"
#include "base/nearest_name.h"
#include "settings/constraints.h"
#include "settings/rows.h"

namespace inkedge {
namespace {

std::vector<SettingDescription> allRows() {
    std::vector<SettingDescription> rows;
    for (const auto& group : {settings::outputRows(), settings::pictureRows(), settings::lineRows(),
                              settings::styleRows(), settings::cameraRows(), settings::modelRows(),
                              settings::limitRows(), settings::detectorRows(), settings::backendRows()})
        rows.insert(rows.end(), group.begin(), group.end());
    return rows;
}

using Groups = std::span<const std::string_view>;
constexpr std::array<std::string_view, 5> renderGroups{"output", "picture", "lines", "style", "detector"};
constexpr std::array<std::string_view, 2> loadGroups{"model", "limits"};
constexpr std::array<std::string_view, 1> cameraGroups{"camera"};
constexpr std::array<std::string_view, 1> frameGroups{"picture"};
constexpr std::array<std::string_view, 1> backendGroups{"backend"};

void validate(const Settings& settings, Groups groups) {
    for (const SettingDescription& row : settingTable()) {
        if (std::ranges::find(groups, row.group) != groups.end()) row.check(settings);
    }
}

// Calls an action that may throw an error about a text, and puts the text's source before the message.
template <class Action>
void named(std::string_view source, Action action) {
    try {
        action();
    } catch (const Error& error) {
        throw Error{error.kind(), fmt::format("{}: {}", source, error.what())};
    }
}

}  // namespace

std::string SettingDescription::values() const {
    return std::visit([](const auto& c) { return settings::formOf(c); }, constraint);
}

std::string SettingDescription::range() const {
    const std::string range = std::visit([](const auto& c) { return settings::rangeOf(c); }, constraint);
    return rangeNote.empty() ? range : fmt::format("{}; {}", range, rangeNote);
}

std::string SettingDescription::defaultValue() const {
    return defaultInWords.empty() ? get({}) : std::string{defaultInWords};
}

void SettingDescription::set(Settings& settings, std::string_view text) const {
    try {
        field.set(constraint, settings, text);
    } catch (const settings::Expected& expected) {
        throw Error{Error::Kind::Usage,
                    fmt::format("expected {}, found {}{}", expected.what, base::quote(text), expected.remedy)};
    }
}

std::string SettingDescription::joined(std::span<const std::string> texts) const {
    const auto* const custom = std::get_if<Custom>(&constraint);
    const char separator = joinedBy != '\0' ? joinedBy : custom != nullptr ? custom->separator : ',';
    return fmt::format("{}", fmt::join(texts, std::string_view{&separator, 1}));
}

std::string SettingDescription::get(const Settings& settings) const { return field.get(constraint, settings); }

void SettingDescription::check(const Settings& settings) const {
    named(name, [&] {
        if (field.check != nullptr) return field.check(settings);
        const std::string text = get(settings);
        Settings taken;
        if (!text.empty()) set(taken, text);
    });
}

std::span<const SettingDescription> settingTable() {
    static const std::vector<SettingDescription> table = allRows();
    return table;
}

std::string settings::suggestSetting(std::string_view name) {
    std::vector<std::string_view> names;
    for (const SettingDescription& row : settingTable()) names.insert(names.end(), {row.name, row.shortName});
    std::erase(names, "");
    return base::suggestion(name, names);
}

const SettingDescription* findSetting(std::string_view name) {
    const auto row = std::ranges::find_if(settingTable(), [&](const SettingDescription& each) {
        return each.name == name || (!name.empty() && each.shortName == name);
    });
    return row == settingTable().end() ? nullptr : &*row;
}

void set(Settings& settings, std::string_view name, std::string_view text, std::string_view source) {
    const SettingDescription* const row = findSetting(name);
    if (row == nullptr)
        throw Error{Error::Kind::Usage,
                    fmt::format("{}: there is no setting named '{}'{}", source, name, settings::suggestSetting(name))};
    named(source, [&] { row->set(settings, text); });
}

std::vector<std::string> idleSettings(const Settings& settings, const OutputKinds& kinds) {
    std::vector<std::string> lines;
    const Settings defaults;
    for (const SettingDescription& row : settingTable()) {
        if (row.idle == nullptr || row.get(settings) == row.get(defaults)) continue;
        const std::string_view why = row.idle(settings, kinds);
        if (!why.empty()) lines.push_back(fmt::format("--{} does nothing: {}", row.name, why));
    }
    return lines;
}

void validate(const Settings& settings) {
    for (const SettingDescription& row : settingTable()) row.check(settings);
}

void validate(const RenderSettings& render) {
    Settings settings;
    static_cast<RenderSettings&>(settings) = render;
    validate(settings, renderGroups);
}

void validate(const LoadSettings& load) {
    Settings settings;
    settings.load = load;
    validate(settings, loadGroups);
}

void validate(const CameraSettings& camera) {
    Settings settings;
    settings.camera = camera;
    validate(settings, cameraGroups);
}

void validate(const FrameSettings& frame) {
    Settings settings;
    settings.frame = frame;
    validate(settings, frameGroups);
}

void validate(const BackendSettings& backend) {
    Settings settings;
    settings.backend = backend;
    validate(settings, backendGroups);
}

}  // namespace inkedge
