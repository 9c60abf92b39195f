#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <inkedge/load_scene.h>
#include <inkedge/scene.h>

#include "base/stage_clock.h"
#include "cli/model_argument.h"
#include "cli/settings_sources.h"
#include "cli/streams.h"
#include "cli/verbs.h"

namespace inkedge::cli {
namespace {

using nlohmann::ordered_json;

struct InspectArguments {
    std::string model;
    bool json = false;
    SettingsSources settings;
};

constexpr std::size_t longestList = 20;  // lines for people; JSON has all

std::string text(const glm::dvec3& v) { return fmt::format("{:.6g},{:.6g},{:.6g}", v.x, v.y, v.z); }
ordered_json toJson(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

std::size_t instancesOf(const Scene& scene, std::size_t mesh) {
    return static_cast<std::size_t>(
        std::ranges::count(scene.instances(), static_cast<std::uint32_t>(mesh), &Instance::mesh));
}

std::string lens(const SceneCamera& camera) {
    return camera.orthographicHeight > 0.0 ? fmt::format("orthographic, {:.6g} high", camera.orthographicHeight)
                                           : fmt::format("perspective, {:.4g} degrees", camera.viewAngle);
}

void printJson(const std::string& model, const Scene& scene, double milliseconds) {
    const SceneSource& source = scene.source();
    ordered_json meshes = ordered_json::array();
    for (std::size_t i = 0; i < scene.meshes().size(); ++i) {
        const Mesh& mesh = scene.meshes()[i];
        meshes.push_back({{"name", mesh.name},
                          {"triangles", mesh.indices.size() / 3},
                          {"vertices", mesh.positions.size()},
                          {"instances", instancesOf(scene, i)}});
    }
    ordered_json cameras = ordered_json::array();
    for (const SceneCamera& camera : scene.cameras()) {
        cameras.push_back({{"name", camera.name},
                           {"type", camera.orthographicHeight > 0.0 ? "orthographic" : "perspective"},
                           {"position", toJson(camera.transform[3])}});
        if (camera.orthographicHeight > 0.0)
            cameras.back()["height"] = camera.orthographicHeight;
        else
            cameras.back()["view_angle"] = camera.viewAngle;
    }
    ordered_json materials = ordered_json::array();
    for (const Material& material : scene.materials())
        materials.push_back({{"name", material.name}, {"double_sided", material.doubleSided}});
    const ordered_json all{{"model", model},
                           {"format", source.format},
                           {"triangles", scene.triangleCount()},
                           {"instances", scene.instances().size()},
                           {"bounds", {{"min", toJson(scene.box().min)}, {"max", toJson(scene.box().max)}}},
                           {"meshes", meshes},
                           {"cameras", cameras},
                           {"materials", materials},
                           {"scenes", source.scenes},
                           {"animations", source.animations},
                           {"extensions", source.extensions},
                           {"warnings", scene.warnings()},
                           {"load_milliseconds", milliseconds}};
    print(all.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

// Prints a heading with the count, and a line for each.
template <class Line>
std::string list(std::string_view heading, std::size_t count, Line&& line) {
    if (count == 0) return {};
    std::string lines = fmt::format("{:<11}{}\n", heading, count);
    for (std::size_t i = 0; i < std::min(count, longestList); ++i) lines += fmt::format("{:>6}  {}\n", i, line(i));
    if (count > longestList) lines += fmt::format("        and {} more: --json lists all\n", count - longestList);
    return lines;
}

void printText(const std::string& model, const Scene& scene) {
    const SceneSource& source = scene.source();
    const auto named = [](const std::string& name) { return name.empty() ? std::string{"(no name)"} : name; };
    std::string lines = fmt::format("{}: {}\n", model, source.format);
    lines += fmt::format("{:<11}{} in {} instances of {} meshes\n", "triangles", scene.triangleCount(),
                         scene.instances().size(), scene.meshes().size());
    lines += fmt::format("{:<11}{} to {}\n", "bounds", text(scene.box().min), text(scene.box().max));
    lines += list("meshes", scene.meshes().size(), [&](std::size_t i) {
        const Mesh& mesh = scene.meshes()[i];
        return fmt::format("{}: {} triangles, {} vertices, {} instances", named(mesh.name), mesh.indices.size() / 3,
                           mesh.positions.size(), instancesOf(scene, i));
    });
    lines += list("cameras", scene.cameras().size(), [&](std::size_t i) {
        return fmt::format("{}: {}", named(scene.cameras()[i].name), lens(scene.cameras()[i]));
    });
    lines += list("materials", scene.materials().size(), [&](std::size_t i) {
        const Material& material = scene.materials()[i];
        return named(material.name) + (material.doubleSided ? ": double-sided" : ": single-sided");
    });
    lines += list("scenes", source.scenes.size(), [&](std::size_t i) { return named(source.scenes[i]); });
    lines += list("animations", source.animations.size(), [&](std::size_t i) { return named(source.animations[i]); });
    if (!source.extensions.empty())
        lines += fmt::format("{:<11}{}\n", "extensions", fmt::join(source.extensions, ", "));
    for (const std::string& warning : scene.warnings()) lines += fmt::format("{:<11}{}\n", "warning", warning);
    print(lines);
}

int inspect(const InspectArguments& arguments) {
    const LoadSettings settings = arguments.settings.resolve().load;
    const base::Stopwatch watch;
    const Scene scene = loadScene(arguments.model, settings);
    const double milliseconds = watch.milliseconds();
    arguments.json ? printJson(arguments.model, scene, milliseconds) : printText(arguments.model, scene);
    return 0;
}

}  // namespace

void addInspect(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<InspectArguments>();
    CLI::App* verb = app.add_subcommand("inspect", "Say what is in a model: meshes, bounds, cameras and warnings.");
    addModel(*verb, arguments->model);
    verb->add_flag("--json", arguments->json, "print it as JSON");
    arguments->settings.addTo(*verb, {"model", "limits"});
    verb->callback([arguments, &action] { action = [arguments] { return inspect(*arguments); }; });
}

}  // namespace inkedge::cli
