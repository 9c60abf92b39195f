#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <inkedge/backends.h>
#include <inkedge/error.h>

#include "cli/streams.h"
#include "cli/verbs.h"
#include "process/child_process.h"

namespace inkedge::cli {
namespace {

using nlohmann::ordered_json;

// A driver may crash or wait for ever: each backend is tried in a process of its own.
constexpr std::chrono::seconds longestTrial{60};
constexpr const char* remedy = "update the graphics driver or Mesa, and look for its variables in the environment";

ordered_json toJson(const BackendReport& report) {
    return {{"backend", report.info.backend},   {"platform", report.info.platform}, {"works", report.works()},
            {"software", report.info.software}, {"vendor", report.info.vendor},     {"renderer", report.info.renderer},
            {"version", report.info.version},   {"failure", report.failure}};
}

BackendReport fromJson(const ordered_json& json) {
    return {{.backend = json["backend"],
             .platform = json["platform"],
             .vendor = json["vendor"],
             .renderer = json["renderer"],
             .version = json["version"],
             .software = json["software"]},
            json["failure"]};
}

// Drivers need not speak UTF-8.
std::string text(const ordered_json& json, int indent = -1) {
    return json.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

std::vector<BackendReport> probeInChildren() {
    const process::Answer list = process::answerOfChild(
        [] {
            ordered_json all = ordered_json::array();
            for (const BackendInfo& info : listBackends()) all.push_back(toJson({info, {}}));
            return text(all);
        },
        longestTrial);
    if (!list.failure.empty()) {
        return {{{.backend = "egl", .platform = "any"},
                 fmt::format("expected libEGL to list its devices, {}; {}", list.failure, remedy)}};
    }
    std::vector<BackendReport> reports;
    for (const ordered_json& each : ordered_json::parse(list.text)) {
        const std::size_t number = reports.size();
        const process::Answer trial =
            process::answerOfChild([number] { return text(toJson(probeBackend(number))); }, longestTrial);
        reports.push_back(fromJson(trial.failure.empty() ? ordered_json::parse(trial.text) : each));
        if (trial.failure.empty()) continue;
        reports.back().failure = fmt::format("expected the driver to start, {}; {}", trial.failure, remedy);
    }
    return reports;
}

void printJson(const std::vector<BackendReport>& reports) {
    ordered_json json = ordered_json::array();
    for (const BackendReport& report : reports) json.push_back(toJson(report));
    print(text({{"backends", json}}, 2) + "\n");
}

void printText(const std::vector<BackendReport>& reports) {
    std::string lines;
    for (const BackendReport& report : reports) {
        const std::string name = fmt::format("{} ({})", report.info.backend, report.info.platform);
        if (report.works()) {
            lines += fmt::format("{:22} works: {}, {}, OpenGL {}{}\n", name, report.info.vendor, report.info.renderer,
                                 report.info.version, report.info.software ? " (software)" : "");
        } else {
            lines += fmt::format("{:22} fails: {}\n", name, report.failure);
        }
    }
    const auto first = std::ranges::find_if(reports, &BackendReport::works);
    lines += first == reports.end()
                 ? "No backend works: nothing can be drawn on this machine yet.\n"
                 : fmt::format("--backend auto draws with {} ({}).\n", first->info.backend, first->info.platform);
    print(lines);
}

int doctor(bool json) {
    const std::vector<BackendReport> reports = probeInChildren();
    json ? printJson(reports) : printText(reports);
    return std::ranges::any_of(reports, &BackendReport::works) ? 0 : static_cast<int>(Error::Kind::Context);
}

}  // namespace

void addDoctor(CLI::App& app, Action& action) {
    const auto json = std::make_shared<bool>(false);
    CLI::App* verb = app.add_subcommand("doctor", "Say which OpenGL backends work here, and why the others do not.");
    verb->add_flag("--json", *json, "print it as JSON");
    verb->callback([json, &action] { action = [json] { return doctor(*json); }; });
}

}  // namespace inkedge::cli
