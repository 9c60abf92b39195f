#include "tune/texts.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/setting_table.h>
#include <inkedge/version.h>

#include "io/metadata.h"

namespace inkedge::tune {
namespace {

using io::Json;

Json vectorJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

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
        json["kind"] = custom.form.starts_with("COLOR") ? "color" : "text";
        json["unit"] = custom.form;
    }
};

Json settingJson(const SettingDescription& row, const Settings& settings) {
    Json json{{"name", row.name},         {"short", row.shortName},        {"group", row.group},
              {"help", row.help},         {"range", row.range()},          {"default", row.defaultValue()},
              {"begin", row.get(Settings{})}, {"value", row.get(settings)}};
    std::visit(ConstraintJson{json}, row.constraint);
    return json;
}

// A word of a POSIX shell.
std::string shellWord(std::string_view text) {
    const bool plain = !text.empty() && std::ranges::all_of(text, [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || std::string_view{"-_./,:=+%@"}.find(c) != std::string_view::npos;
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
        if (row.name != "maps" && row.get(settings) != row.get(defaults)) rows.push_back(&row);
    return rows;
}

std::string commandText(const std::string& model, const Settings& settings) {
    // A name that begins with - would be a flag.
    std::string text = fmt::format("inkedge render {} -o drawing.png", shellWord(model));
    for (const SettingDescription* row : changed(settings))
        text += fmt::format(" --{}", shellWord(fmt::format("{}={}", row->name, row->get(settings))));
    return text;
}

std::string pythonString(std::string_view text) { return Json(io::validText(text)).dump(); }

std::string pythonText(const std::string& model, const Settings& settings) {
    std::vector<std::string> load;
    std::vector<std::string> frame;
    std::vector<std::string> draw;
    for (const SettingDescription* row : changed(settings)) {
        std::string keyword{row->name};
        std::ranges::replace(keyword, '-', '_');
        const std::string argument = fmt::format(", {}={}", keyword, pythonString(row->get(settings)));
        if (row->group == "camera") {
            frame.push_back(argument);
        } else if (row->group == "model" || row->group == "limits") {
            load.push_back(argument);
        } else if (row->group != "backend") {
            draw.push_back(argument);
        }
    }
    return fmt::format(
        "import inkedge\n\nscene = inkedge.Scene.load({}{}{})\ncamera = inkedge.Camera.frame(scene{})\n"
        "with inkedge.Renderer(backend={}) as renderer:\n    maps = renderer.render(scene, camera{})\n"
        "inkedge.write_png(\"drawing.png\", maps[\"picture\"])\n",
        pythonString(model), fmt::join(load, ""), fmt::join(draw, ""), fmt::join(frame, ""),
        pythonString(findSetting("backend")->get(settings)), fmt::join(draw, ""));
}

}  // namespace

std::string beginningJson(const Scene& scene, const std::string& model, const Settings& settings) {
    Json rows = Json::array();
    for (const SettingDescription& row : settingTable())
        if (row.name != "maps" && row.name != "tile-size") rows.push_back(settingJson(row, settings));
    Json presetRows = Json::array();
    for (const Preset& preset : presets()) {
        Json values = Json::object();
        for (const auto& [name, text] : preset.values)
            if (name != "maps") values[std::string{name}] = text;
        presetRows.push_back({{"name", preset.name}, {"help", preset.help}, {"values", std::move(values)}});
    }
    const Json json{{"model", io::validText(model)},
                    {"version", version()},
                    {"triangles", scene.triangleCount()},
                    {"centre", vectorJson(scene.bounds().centre)},
                    {"radius", scene.bounds().radius},
                    {"up", vectorJson(scene.up())},
                    {"warnings", scene.warnings()},
                    {"maps", std::get<List>(findSetting("maps")->constraint).names},
                    {"presets", std::move(presetRows)},
                    {"settings", std::move(rows)}};
    return io::textOf(json, -1);
}

Settings settingsOf(const std::map<std::string, std::string>& texts) {
    Settings settings;
    for (const auto& [name, text] : texts) set(settings, name, text, "--" + name);
    return settings;
}

std::string takeAwayJson(const std::string& model, const Settings& settings) {
    const Json json{{"command", io::validText(commandText(model, settings))},
                    {"config", configText(settings)},
                    {"python", pythonText(model, settings)},
                    {"idle", idleSettings(settings, OutputKinds{.pictures = true})}};
    return io::textOf(json, -1);
}

}  // namespace inkedge::tune
