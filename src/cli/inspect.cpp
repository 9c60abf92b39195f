#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <inkedge/inspect_model.h>
#include <inkedge/setting_table.h>
#include <inkedge/write.h>

#include "base/message.h"
#include "base/stage_clock.h"
#include "cli/model_argument.h"
#include "cli/settings_sources.h"
#include "cli/streams.h"
#include "cli/verbs.h"

namespace inkedge::cli {
namespace {

using nlohmann::ordered_json;

struct InspectArguments {
    ModelArgument model;
    bool json = false;
    SettingsSources settings;
};

constexpr std::size_t longestList = 20;  // lines for people; JSON has all

// + 0.0 makes a 0 of -0.
std::string text(const glm::dvec3& v) { return fmt::format("{:.6g},{:.6g},{:.6g}", v.x + 0.0, v.y + 0.0, v.z + 0.0); }

// As --up takes it: "+Z".
std::string upText(const glm::dvec3& up) {
    Settings settings;
    settings.load.up = up;
    return findSetting("up")->get(settings);
}

// As --unit takes it: "mm".
std::string unitText(LengthUnit unit) {
    if (unit == LengthUnit::None) return "not said";
    Settings settings;
    settings.load.unit = unit;
    return findSetting("unit")->get(settings);
}

ordered_json toJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

std::string lens(const SceneCamera& camera) {
    return camera.orthographicHeight > 0.0 ? fmt::format("orthographic, {:.6g} high", camera.orthographicHeight)
                                           : fmt::format("perspective, {:.4g} degrees", camera.viewAngle);
}

void printJson(const std::string& model, const ModelContents& contents, double milliseconds) {
    const SceneSource& source = contents.source;
    ordered_json meshes = ordered_json::array();
    for (const MeshContents& mesh : contents.meshes) {
        meshes.push_back({{"name", mesh.name},
                          {"triangles", mesh.triangles},
                          {"lines", mesh.lines},
                          {"vertices", mesh.vertices},
                          {"instances", mesh.instances}});
    }
    ordered_json cameras = ordered_json::array();
    for (const SceneCamera& camera : contents.cameras) {
        cameras.push_back({{"name", camera.name},
                           {"type", camera.orthographicHeight > 0.0 ? "orthographic" : "perspective"},
                           {"position", toJson(camera.transform[3])}});
        if (camera.orthographicHeight > 0.0)
            cameras.back()["height"] = camera.orthographicHeight;
        else
            cameras.back()["view_angle"] = camera.viewAngle;
    }
    ordered_json materials = ordered_json::array();
    for (const Material& material : contents.materials)
        materials.push_back(
            {{"id", materials.size() + 1}, {"name", material.name}, {"double_sided", material.doubleSided}});
    ordered_json bounds;  // null
    if (!contents.box.empty()) bounds = {{"min", toJson(contents.box.min)}, {"max", toJson(contents.box.max)}};
    const ordered_json all{{"model", model},
                           {"format", source.format},
                           {"triangles", contents.triangles},
                           {"lines", contents.lines},
                           {"not_drawn", contents.undrawn},
                           {"instances", ordered_json::parse(namesJson({contents.instances, {}})).at("instances")},
                           {"up", toJson(contents.up)},
                           {"unit", unitText(source.unit)},
                           {"bounds", bounds},
                           {"meshes", meshes},
                           {"cameras", cameras},
                           {"materials", materials},
                           {"scenes", source.scenes},
                           {"animations", source.animations},
                           {"extensions", source.extensions},
                           {"warnings", contents.warnings},
                           {"load_milliseconds", milliseconds}};
    print(all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

// Prints a heading with the count, and a line for each.
// @param first  its number: as flags take it, or as ids count
template <class Line>
std::string list(std::string_view heading, std::size_t count, Line&& line, std::size_t first = 0) {
    if (count == 0) return {};
    std::string lines = fmt::format("{:<11}{}\n", heading, count);
    for (std::size_t i = 0; i < std::min(count, longestList); ++i)
        lines += fmt::format("{:>6}  {}\n", first + i, line(i));
    if (count > longestList) lines += fmt::format("        and {} more: --json lists all\n", count - longestList);
    return lines;
}

void printText(const std::string& model, const ModelContents& contents) {
    const SceneSource& source = contents.source;
    const auto named = [](const std::string& name) {
        return name.empty() ? std::string{"(no name)"} : base::printable(name);
    };
    std::string lines = fmt::format("{}: {}\n", base::printable(model), source.format);
    lines += fmt::format("{:<11}{} in {} instances of {} meshes\n", "triangles", contents.triangles,
                         contents.instances.size(), contents.meshes.size());
    if (contents.lines > 0) lines += fmt::format("{:<11}{}, as straight pieces\n", "lines", contents.lines);
    if (!contents.undrawn.empty()) lines += fmt::format("{:<11}{}\n", "not drawn", fmt::join(contents.undrawn, ", "));
    if (!contents.box.empty()) {
        lines += fmt::format("{:<11}{} to {}\n", "bounds", text(contents.box.min), text(contents.box.max));
        lines += fmt::format("{:<11}{}\n", "up", upText(contents.up));
        lines += fmt::format("{:<11}{}\n", "unit", unitText(source.unit));
    }
    lines += list("meshes", contents.meshes.size(), [&](std::size_t i) {
        const MeshContents& mesh = contents.meshes[i];
        const std::string ofLines = mesh.lines > 0 ? fmt::format("{} lines, ", mesh.lines) : "";
        return fmt::format("{}: {} triangles, {}{} vertices, {} instances", named(mesh.name), mesh.triangles, ofLines,
                           mesh.vertices, mesh.instances);
    });
    lines += list("cameras", contents.cameras.size(), [&](std::size_t i) {
        return fmt::format("{}: {}", named(contents.cameras[i].name), lens(contents.cameras[i]));
    });
    lines += list(
        "materials", contents.materials.size(),
        [&](std::size_t i) {
            const Material& material = contents.materials[i];
            return named(material.name) + (material.doubleSided ? ": double-sided" : ": single-sided");
        },
        1);
    lines += list("scenes", source.scenes.size(), [&](std::size_t i) { return named(source.scenes[i]); });
    lines += list("animations", source.animations.size(), [&](std::size_t i) { return named(source.animations[i]); });
    if (!source.extensions.empty())
        lines += fmt::format("{:<11}{}\n", "extensions",
                             base::printable(fmt::format("{}", fmt::join(source.extensions, ", "))));
    for (const std::string& warning : contents.warnings) lines += fmt::format("{:<11}{}\n", "warning", warning);
    print(lines);
}

int inspect(const InspectArguments& arguments) {
    const LoadSettings settings = arguments.settings.resolve().load;
    const GivenModel model = std::move(arguments.model.models(settings.limits).front());
    const base::Stopwatch watch;
    const ModelContents contents =
        model.bytes ? inspectModel(*model.bytes, model.name, settings) : inspectModel(model.name, settings);
    const double milliseconds = watch.milliseconds();
    arguments.json ? printJson(model.name.string(), contents, milliseconds) : printText(model.name.string(), contents);
    return 0;
}

}  // namespace

void addInspect(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<InspectArguments>();
    CLI::App* verb = app.add_subcommand("inspect", "Say what is in a model: meshes, bounds, cameras and warnings.");
    arguments->model.addTo(*verb);
    verb->add_flag("--json", arguments->json, "print it as JSON");
    arguments->settings.addTo(
        *verb, [](const SettingDescription& row) { return row.group == "model" || row.group == "limits"; });
    verb->callback([arguments, &action] { action = [arguments] { return inspect(*arguments); }; });
}

}  // namespace inkedge::cli
