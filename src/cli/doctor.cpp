#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>
#include <inkedge/renderer.h>

#include "cli/verbs.h"

namespace inkedge::cli {
namespace {

void printJson(const std::vector<BackendReport>& reports) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const BackendReport& report : reports) {
        json.push_back({{"backend", report.info.backend},
                        {"platform", report.info.platform},
                        {"works", report.works()},
                        {"software", report.info.software},
                        {"vendor", report.info.vendor},
                        {"renderer", report.info.renderer},
                        {"version", report.info.version},
                        {"failure", report.failure}});
    }
    fmt::print("{}\n", nlohmann::ordered_json{{"backends", json}}.dump(2));
}

void printText(const std::vector<BackendReport>& reports) {
    for (const BackendReport& report : reports) {
        const std::string name = fmt::format("{} ({})", report.info.backend, report.info.platform);
        if (report.works()) {
            fmt::print("{:22} works: {}, {}, OpenGL {}{}\n", name, report.info.vendor, report.info.renderer,
                       report.info.version, report.info.software ? " (software)" : "");
        } else {
            fmt::print("{:22} fails: {}\n", name, report.failure);
        }
    }
    const auto first = std::ranges::find_if(reports, &BackendReport::works);
    fmt::print("{}\n", first == reports.end() ? "No backend works: nothing can be drawn on this machine yet."
                                              : fmt::format("--backend auto draws with {} ({}).", first->info.backend,
                                                            first->info.platform));
}

int doctor(bool json) {
    const std::vector<BackendReport> reports = probeBackends();
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
