#include <algorithm>
#include <memory>
#include <optional>
#include <thread>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <inkedge/encode_png.h>
#include <inkedge/error.h>
#include <inkedge/job.h>
#include <inkedge/renderer.h>
#include <inkedge/views.h>

#include "base/message.h"
#include "cli/checks.h"
#include "cli/model_argument.h"
#include "cli/progress.h"
#include "cli/settings_sources.h"
#include "cli/streams.h"
#include "cli/verbs.h"
#include "process/driver_threads.h"
#include "process/signals.h"

namespace inkedge::cli {
namespace {

struct RenderArguments {
    ModelArgument models;
    std::string output;
    std::string metadataFile;
    std::string views;              // as viewsOf() takes them; empty: one
    int jobs = 0;                   // 0: as many as there are cores
    std::optional<double> timeout;  // seconds
    bool json = false;
    bool printsConfig = false;
    bool quiet = false;
    bool verbose = false;
    SettingsSources settings;
};

void checkStandardOutput(const RenderArguments& arguments, const Settings& settings) {
    if (arguments.output != "-") return;
    if (arguments.json) throw Error{Error::Kind::Usage, "--json: expected --output FILE, found - (both use stdout)"};
    if (!settings.maps.empty()) throw Error{Error::Kind::Usage, "--maps: expected --output FILE, found -"};
    if (arguments.models.names().size() > 1)
        throw Error{Error::Kind::Usage, fmt::format("--output: expected a FILE with {{model}} for {} models, found -",
                                                    arguments.models.names().size())};
    if (!arguments.views.empty()) throw Error{Error::Kind::Usage, "--views: expected --output FILE, found -"};
}

void startTimeout(const RenderArguments& arguments) {
    if (!arguments.timeout) return;
    process::limitTime(
        *arguments.timeout,
        fmt::format("inkedge: error: {}: expected the work to end within {} s, found it still going; raise "
                    "--timeout or ask for less (a smaller model, --size or --supersampling)\n",
                    base::printable(fmt::format("{}", fmt::join(arguments.models.names(), ", "))), *arguments.timeout));
}

void warnOfIdleSettings(const RenderArguments& arguments, const Job& job) {
    if (arguments.quiet) return;
    for (const std::string& line : idleSettings(job)) report("warning: ", line);
    for (const std::string& name : SettingsSources::unknownVariables())
        report("warning: ", fmt::format("{} does nothing: no setting has this name", base::printable(name)));
}

void warn(const RenderArguments& arguments, const Job& job, const Scene& scene) {
    if (arguments.quiet) return;
    const auto say = [&](const std::string& warning) {
        report("warning: ", fmt::format("{}: {}", job.model.string(), warning));
    };
    std::ranges::for_each(renderWarnings(scene, job.settings), say);
    std::ranges::for_each(scene.warnings(), say);
}

void printViews(const JobResult& result) {
    const BackendInfo& by = result.backend;
    report("", by.backend.empty()
                   ? std::string{"drawn without OpenGL"}
                   : fmt::format("drawn by {} ({}): {}, OpenGL {}", by.backend, by.platform, by.renderer, by.version));
    for (const StageTime& time : result.times)
        report("", fmt::format("{:>10} {:8.1f} ms", time.stage, time.milliseconds));
    for (const auto& file : result.files) report("wrote ", file.string());
}

void printJson(const RenderArguments& arguments, const std::vector<JobResult>& results) {
    using nlohmann::ordered_json;
    ordered_json all = ordered_json::array();
    for (const JobResult& result : results) all.push_back(ordered_json::parse(result.metadata));
    const bool one = arguments.views.empty() && arguments.models.names().size() == 1;
    const ordered_json& shown = one ? all.front() : all;
    print(shown.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
}

// A model and an output are needed but to print the configuration.
void expectGiven(const RenderArguments& arguments) {
    if (arguments.models.names().empty()) throw CLI::RequiredError("MODEL");
    if (arguments.output.empty()) throw CLI::RequiredError("--output");
}

int printConfig(const RenderArguments& arguments) {
    print(configText(arguments.settings.resolve()));
    return 0;
}

// Whether there is a context for each core, and work for it.
bool keepsAllCoresBusy(const RenderArguments& arguments, std::size_t pictures) {
    constexpr std::size_t picturesOfACore = 8;
    const auto cores = std::max<std::size_t>(std::thread::hardware_concurrency(), 1);
    const std::size_t atOnce = arguments.jobs == 0 ? cores : static_cast<std::size_t>(arguments.jobs);
    return atOnce >= cores && pictures >= picturesOfACore * cores;
}

int render(const RenderArguments& arguments) {
    startTimeout(arguments);
    Job job{.model = {}, .settings = arguments.settings.resolve(), .metadata = arguments.metadataFile};
    checkStandardOutput(arguments, job.settings);
    if (!arguments.views.empty()) job.views = viewsOf(arguments.views, job.settings.camera);
    for (const std::string& read : {arguments.views, arguments.settings.configFile()})
        if (!read.empty()) job.inputs.emplace_back(read);
    JobOptions options{.workers = arguments.jobs, .metadata = arguments.json};
    if (arguments.output == "-") {
        options.drawn = [](std::size_t, std::size_t, const Maps& maps) {
            const std::vector<std::uint8_t> png = encodePng(maps.picture, maps.dpi);
            print({reinterpret_cast<const char*>(png.data()), png.size()});
        };
    } else {
        job.outputs = {arguments.output};
    }
    const std::size_t views = std::max<std::size_t>(job.views.size(), 1);
    const std::vector<std::string>& names = arguments.models.names();
    if (keepsAllCoresBusy(arguments, names.size() * views)) process::drawInCallingThreads();
    Progress progress{names.front(), names.size() * views, !arguments.quiet};
    const std::vector<GivenModel> models = arguments.models.models(job.settings.load.limits);
    std::vector<Job> jobs(models.size(), job);
    for (std::size_t i = 0; i < jobs.size(); ++i) jobs[i].model = models[i].name, jobs[i].bytes = models[i].content();
    checkJobs(jobs);
    warnOfIdleSettings(arguments, jobs.front());
    options.loaded = [&](std::size_t number, const Scene& scene) {
        progress.modelRead();
        warn(arguments, jobs[number], scene);
    };
    options.progress = [&](std::size_t, std::size_t) { progress.viewEnded(); };
    std::vector<JobResult> results(jobs.size() * views);
    options.finished = [&](const JobResult& result) { results[result.job * views + result.view] = result; };
    runJobs(jobs, options);

    if (arguments.json) printJson(arguments, results);
    if (arguments.verbose) std::ranges::for_each(results, printViews);
    return 0;
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App* verb = app.add_subcommand("render", "Draw the outlines of models.");
    arguments->models.addSeveralTo(*verb);
    verb->add_option("-o,--output", arguments->output,
                     "picture to write, .png .tif .exr .npz, or lines, .svg .pdf .dxf .json, or - for PNG on stdout; "
                     "{model}, {view} "
                     "and {map} are filled in")
        ->type_name("FILE");
    verb->add_option("--metadata", arguments->metadataFile,
                     "write camera, names, settings, backend and timings as JSON; without {view} in it "
                     "one file for all views")
        ->type_name("FILE");
    verb->add_option("--views", arguments->views,
                     "draw several views: names as for --view, turntable:N, sphere:N and random:N:SEED with commas "
                     "between them, or a JSON list of camera settings; --output needs {view}")
        ->type_name("VIEWS");
    verb->add_option("--jobs", arguments->jobs, "views drawn at the same time [cores]")
        ->check(numberFrom(1, 1024))
        ->type_name("N");
    verb->add_option("--timeout", arguments->timeout, "end with exit status 1 if it takes longer")
        ->check(numberOver(0.0, process::longestTimeout))
        ->type_name("SECONDS");
    verb->add_flag("--json", arguments->json, "print the metadata and the files written on stdout");
    verb->add_flag("--print-config", arguments->printsConfig,
                   "print what differs from the defaults as lines of a --config file, and draw nothing");
    verb->add_flag("-q,--quiet", arguments->quiet, "no warnings");
    verb->add_flag("-v,--verbose", arguments->verbose, "say what drew the picture, the timings and the files written");
    arguments->settings.addTo(*verb);
    verb->callback([arguments, &action] {
        if (!arguments->printsConfig) expectGiven(*arguments);
        action = [arguments] { return arguments->printsConfig ? printConfig(*arguments) : render(*arguments); };
    });
}

}  // namespace inkedge::cli
