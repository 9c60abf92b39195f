#include "batch/plan.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/setting_table.h>
#include <inkedge/version.h>

#include "base/content_hash.h"
#include "job/file_names.h"
#include "settings/json_text.h"

namespace inkedge::batch {
namespace {

namespace fs = std::filesystem;
using io::Json;

void apply(const Json& values, Settings& settings) {
    if (!values.is_object()) return;
    for (const auto& [name, value] : values.items())
        if (!value.is_null()) set(settings, name, settings::textOfJson(value), "settings: " + name);
}

// How a context is made, and what a file may take, changes no picture.
bool makesADifference(const SettingDescription& row) { return row.group != "backend" && row.group != "limits"; }

std::string describe(const Plan& plan, const std::vector<std::string>& formats) {
    Json text{{"version", version()},
              {"score", plan.score},
              {"formats", formats},
              {"settings", Json::object()},
              {"views", Json::array()}};
    Settings settings = plan.job.settings;
    for (const SettingDescription& row : settingTable())
        if (makesADifference(row) && row.group != "camera") text["settings"][std::string{row.name}] = row.get(settings);
    for (const View& view : plan.views) {
        Json& json = text["views"].emplace_back(Json{{"name", view.name}});
        settings.camera = view.camera;
        for (const SettingDescription& row : settingTable())
            if (row.group == "camera") json[std::string{row.name}] = row.get(settings);
    }
    return io::textOf(text, -1);
}

void expectKeys(const std::vector<View>& views) {
    for (const View& view : views)
        if (view.name.find('.') != std::string::npos)
            throw Error{Error::Kind::Usage,
                        fmt::format("--shards: expected views without a dot in their names, found '{}': what stands "
                                    "before the first dot is the key of a sample",
                                    view.name)};
}

}  // namespace

Json differencesOf(const Settings& settings) {
    const Settings defaults;
    Json values = Json::object();
    for (const SettingDescription& row : settingTable())
        if (std::string text = row.get(settings); text != row.get(defaults)) values[std::string{row.name}] = text;
    return values;
}

Planner::Planner(const Batch& batch)
    : output_{batch.output},
      settings_{batch.settings},
      views_{batch.views},
      formats_{batch.formats},
      shards_{batch.shards.has_value()} {
    common_.score = batch.score;
    prepare();
}

Planner::Planner(const std::string& text) {
    const Json json = Json::parse(text);
    output_ = json.at("output").get<std::string>();
    views_ = json.at("views").get<std::string>();
    formats_ = json.at("formats").get<std::vector<std::string>>();
    shards_ = json.at("shards").get<bool>();
    common_.score = json.at("score").get<bool>();
    apply(json.at("settings"), settings_);
    prepare();
}

void Planner::prepare() {
    common_.job.settings = settings_;
    for (const std::string& format : formats_) common_.job.outputs.push_back("{view}.{map}." + format);
    if (!views_.empty()) common_.job.views = viewsOf(views_, settings_.camera);
    common_.views = job::viewsOf(common_.job);
    if (shards_) expectKeys(common_.views);
    common_.settings = describe(common_, formats_);
}

std::string Planner::text() const {
    return io::textOf(Json{{"output", output_.string()},
                           {"views", views_},
                           {"formats", formats_},
                           {"shards", shards_},
                           {"score", common_.score},
                           {"settings", differencesOf(settings_)}},
                      -1);
}

Plan Planner::planOf(const Item& item) const {
    Plan plan = common_;
    plan.job.model = item.model;
    if (item.settings.is_null() && item.views.empty()) return plan;
    apply(item.settings, plan.job.settings);
    const std::string& views = item.views.empty() ? views_ : item.views;
    if (!views.empty()) plan.job.views = viewsOf(views, plan.job.settings.camera);
    plan.views = job::viewsOf(plan.job);
    if (shards_) expectKeys(plan.views);
    plan.settings = describe(plan, formats_);
    return plan;
}

std::string cameraFileOf(const View& view) { return view.name + ".json"; }

std::vector<fs::path> filesOf(const Plan& plan) {
    std::vector<fs::path> files;
    for (const View& view : plan.views) {
        for (fs::path& file : inkedge::filesOf(plan.job, view)) files.push_back(std::move(file));
        files.emplace_back(cameraFileOf(view));
    }
    return files;
}

std::string keyOf(const Plan& plan, const fs::path& model) {
    base::ContentHash hash;
    hash.add(plan.settings);
    hash.add(base::hashOfFile(model).value_or("none"));
    return hash.hex();
}

fs::path partOf(const std::string& id, const std::string& key) {
    return fmt::format(".part-{:016x}.tar", base::hashOf(id + '\n' + key));
}

}  // namespace inkedge::batch
