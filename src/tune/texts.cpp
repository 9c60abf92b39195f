#include "tune/texts.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include <inkedge/setting_table.h>
#include <inkedge/version.h>

#include "io/metadata.h"

namespace inkedge::tune {
namespace {

using io::Json;

Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::vector<std::string_view> namesOf(LineTypes types) {
    std::vector<std::string_view> names;
    for (const LineType type : types) names.push_back(name(type));
    return names;
}

// What a control needs to know.
struct ConstraintJson {
    Json& json;
    void operator()(const Number& number) const {
        json["kind"] = "number";
        json["min"] = numberOrNull(number.min);
        json["max"] = numberOrNull(number.max);
        json["unit"] = number.unit;
    }
    void operator()(const Count& count) const {
        json["kind"] = count.choices.empty() ? "count" : "choice";
        json["min"] = count.min;
        json["max"] = count.max;
        json["unit"] = count.unit;
        for (const int choice : count.choices) json["choices"].push_back(fmt::format("{}", choice));
    }
    void operator()(const Choice& choice) const {
        json["kind"] = "choice";
        json["choices"] = choice.names;
    }
    void operator()(const List& list) const {
        json["kind"] = "list";
        json["choices"] = list.names;
    }
    void operator()(const Custom& custom) const {
        json["kind"] = kindOf(custom.form);
        json["unit"] = custom.form;
        if (json["kind"] != "pens") return;
        json["choices"] = namesOf(allLineTypes);
        json["choices"].push_back("hidden");
    }
    static std::string_view kindOf(std::string_view form) {
        if (form.starts_with("COLOR")) return "color";
        if (form.starts_with("TYPE:")) return "pens";
        if (form == "X,Y,Z") return "vector";
        return form == "PX" ? "length" : "text";
    }
};

Json settingJson(const SettingDescription& row, const Settings& settings) {
    Json json{{"name", row.name},
              {"short", row.shortName},
              {"group", row.group},
              {"help", row.help},
              {"range", row.range()},
              {"default", row.defaultValue()},
              {"begin", row.get(Settings{})},
              {"value", row.get(settings)}};
    std::visit(ConstraintJson{json}, row.constraint);
    if (row.name == "lines") json["words"] = {{"standard", namesOf(standardLineTypes)}, {"all", namesOf(allLineTypes)}};
    return json;
}

// A word of a POSIX shell.
std::string shellWord(std::string_view text) {
    const bool plain = !text.empty() && std::ranges::all_of(text, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) ||
               std::string_view{"-_./,:=+%@"}.find(c) != std::string_view::npos;
    });
    if (plain) return std::string{text};
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string{"'\\''"} : std::string{c};
    return word + "'";
}

std::vector<const SettingDescription*> changed(const Settings& settings) {
    std::vector<const SettingDescription*> rows;
    const Settings defaults;
    for (const SettingDescription& row : settingTable())
        if (row.get(settings) != row.get(defaults)) rows.push_back(&row);
    return rows;
}

constexpr const char* drawnFile = "drawing.png";

// A name that begins with - would be a flag.
std::string modelText(const std::string& model) { return model.starts_with('-') ? "./" + model : model; }

std::string commandText(const std::string& model, const Settings& settings) {
    std::string text = fmt::format("inkedge render {} -o {}", shellWord(modelText(model)), drawnFile);
    for (const SettingDescription* row : changed(settings))
        text += fmt::format(" --{}={}", row->name, shellWord(row->get(settings)));
    return text;
}

std::string configFileText(const std::string& model, const Settings& settings) {
    return fmt::format("# inkedge render {} -o {} --config THIS_FILE\n{}", shellWord(modelText(model)), drawnFile,
                       configText(settings));
}

std::string pythonString(std::string_view text) { return Json(io::validText(text)).dump(); }

// "line_width=\"3\", size=\"64x64\"" of the settings whose group fits.
template <class Fits>
std::string keywords(const Settings& settings, Fits fits) {
    std::string text;
    for (const SettingDescription* row : changed(settings)) {
        if (!fits(row->group)) continue;
        std::string keyword{row->name};
        std::ranges::replace(keyword, '-', '_');
        text += fmt::format("{}{}={}", text.empty() ? "" : ", ", keyword, pythonString(row->get(settings)));
    }
    return text;
}

std::string pythonText(const std::string& model, const Settings& settings) {
    const auto isCamera = [](std::string_view group) { return group == "camera"; };
    const auto isLoad = [](std::string_view group) { return group == "model" || group == "limits"; };
    const auto isBackend = [](std::string_view group) { return group == "backend"; };
    const auto isDrawing = [&](auto group) { return !isCamera(group) && !isLoad(group) && !isBackend(group); };
    const std::string load = keywords(settings, isLoad);
    return fmt::format(
        "import inkedge\n\n"
        "view = dict({})\n"
        "drawing = dict({})\n"
        "scene = inkedge.Scene.load({}{}{}, **view, **drawing)\n"
        "camera = inkedge.Camera.frame(scene, **view)\n"
        "with inkedge.Renderer({}) as renderer:\n"
        "    maps = renderer.render(scene, camera, **drawing)\n"
        "inkedge.write_png(\"{}\", maps[\"picture\"])\n",
        keywords(settings, isCamera), keywords(settings, isDrawing), pythonString(modelText(model)),
        load.empty() ? "" : ", ", load, keywords(settings, isBackend), drawnFile);
}

// By name, why the setting does nothing.
Json idleOf(const Settings& settings) {
    Json idle = Json::object();
    const OutputKinds picture{.pictures = true};
    const Settings defaults;
    for (const SettingDescription& row : settingTable()) {
        if (row.idle == nullptr || row.get(settings) == row.get(defaults)) continue;
        if (const std::string_view why = row.idle(settings, picture); !why.empty()) idle[std::string{row.name}] = why;
    }
    return idle;
}

}  // namespace

std::string beginningJson(const Scene& scene, const std::string& model, const Settings& settings) {
    Json rows = Json::array();
    for (const SettingDescription& row : settingTable()) rows.push_back(settingJson(row, settings));
    Json presetRows = Json::array();
    for (const Preset& preset : presets()) {
        Json values = Json::object();
        for (const auto& [name, text] : preset.values) values[std::string{name}] = text;
        presetRows.push_back({{"name", preset.name}, {"help", preset.help}, {"values", std::move(values)}});
    }
    const Json json{{"model", io::validText(model)},      {"version", version()},
                    {"triangles", scene.triangleCount()}, {"warnings", scene.warnings()},
                    {"presets", std::move(presetRows)},   {"settings", std::move(rows)}};
    return io::textOf(json, -1);
}

Settings settingsOf(const std::map<std::string, std::string>& texts) {
    Settings settings;
    for (const auto& [name, text] : texts) set(settings, name, text, "--" + name);
    return settings;
}

std::string takeAwayJson(const std::string& model, const Settings& settings) {
    const Json json{{"command", io::validText(commandText(model, settings))},
                    {"config", io::validText(configFileText(model, settings))},
                    {"python", pythonText(model, settings)},
                    {"idle", idleOf(settings)}};
    return io::textOf(json, -1);
}

}  // namespace inkedge::tune
