#pragma once

#include <cmath>
#include <optional>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <inkedge/setting_table.h>

#include "settings/names.h"
#include "settings/text.h"

/// Rows of the table of settings. A field is a function without state that finds a value in Settings:
/// [](auto& s) -> auto& { return s.picture.dpi; }
namespace inkedge::settings {

/// The parts of a row besides its constraint.
struct About {
    std::string_view name = {};
    std::string_view shortName = {};
    std::string_view help = {};
    std::string_view rangeNote = {};
    std::string_view defaultInWords = {};
    char joinedBy = '\0';
    std::string_view (*idle)(const Settings&, const OutputKinds&) = nullptr;
};

template <class T>
struct ValueOf {
    using Type = T;
};
template <class T>
struct ValueOf<std::optional<T>> {
    using Type = T;
};
template <class Field>
using FieldValue = typename ValueOf<std::decay_t<decltype(Field{}(std::declval<Settings&>()))>>::Type;

template <class Enumerator>
std::string nameOf(std::span<const std::string_view> names, Enumerator value) {
    return nameOf(names, static_cast<int>(value));
}
template <class Enumerator>
std::string nameOf(std::span<const std::string_view> names, const std::optional<Enumerator>& value) {
    return value ? nameOf(names, *value) : std::string{};
}

inline SettingDescription described(const About& about, Constraint constraint, SettingDescription::Field field) {
    return {about.name,           about.shortName, {},         about.help, constraint, about.rangeNote,
            about.defaultInWords, about.joinedBy,  about.idle, field};
}

template <class Field>
SettingDescription row(const About& about, const Number& number, Field) {
    return described(about, number,
                     {[](const Constraint& c, Settings& s, std::string_view text) {
                          Field{}(s) = static_cast<FieldValue<Field>>(parseNumber(std::get<Number>(c), text));
                      },
                      [](const Constraint&, const Settings& s) { return textOf(Field{}(s)); }});
}

template <class Field>
SettingDescription row(const About& about, const Count& count, Field) {
    return described(about, count,
                     {[](const Constraint& c, Settings& s, std::string_view text) {
                          Field{}(s) = static_cast<FieldValue<Field>>(parseCount(std::get<Count>(c), text));
                      },
                      [](const Constraint&, const Settings& s) { return textOf(Field{}(s)); }});
}

template <class Field>
SettingDescription row(const About& about, const Choice& choice, Field) {
    return described(
        about, choice,
        {[](const Constraint& c, Settings& s, std::string_view text) {
             Field{}(s) = static_cast<FieldValue<Field>>(parseChoice(std::get<Choice>(c).names, text));
         },
         [](const Constraint& c, const Settings& s) { return nameOf(std::get<Choice>(c).names, Field{}(s)); }});
}

/// @param parse  makes a value, or the value of an optional, from text
template <auto parse, class Field>
SettingDescription row(const About& about, const Custom& custom, Field) {
    return described(about, custom,
                     {[](const Constraint&, Settings& s, std::string_view text) { Field{}(s) = parse(text); },
                      [](const Constraint&, const Settings& s) { return textOf(Field{}(s)); }});
}

inline std::vector<SettingDescription> inGroup(std::string_view group, std::vector<SettingDescription> rows) {
    for (SettingDescription& row : rows) row.group = group;
    return rows;
}

/// The groups, in the order of the manual.
[[nodiscard]] std::vector<SettingDescription> outputRows();
[[nodiscard]] std::vector<SettingDescription> pictureRows();
[[nodiscard]] std::vector<SettingDescription> lineRows();
[[nodiscard]] std::vector<SettingDescription> styleRows();
[[nodiscard]] std::vector<SettingDescription> cameraRows();
[[nodiscard]] std::vector<SettingDescription> modelRows();
[[nodiscard]] std::vector<SettingDescription> limitRows();
[[nodiscard]] std::vector<SettingDescription> detectorRows();
[[nodiscard]] std::vector<SettingDescription> backendRows();

/// "; is it line-width?" for a name that is no setting's; empty: none is like it.
[[nodiscard]] std::string suggestSetting(std::string_view name);

}  // namespace inkedge::settings
