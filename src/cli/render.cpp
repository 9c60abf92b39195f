#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <inkedge/renderer.h>
#include <inkedge/views.h>
#include <inkedge/write.h>

#include "base/stage_clock.h"
#include "cli/checks.h"
#include "cli/settings_sources.h"
#include "cli/signals.h"
#include "cli/streams.h"
#include "cli/verbs.h"

namespace inkedge::cli {
namespace {

struct RenderArguments {
    std::string model;
    std::string output;
    std::string metadataFile;
    std::string views;              // as viewsOf() takes them; empty: one
    int jobs = 0;                   // 0: as many as there are cores
    std::optional<double> timeout;  // seconds
    bool json = false;
    bool quiet = false;
    bool verbose = false;
    SettingsSources settings;
};

std::string expandField(std::string text, const std::string& field, const std::string& value) {
    for (std::size_t at = 0; (at = text.find(field, at)) != std::string::npos; at += value.size()) {
        text.replace(at, field.size(), value);
    }
    return text;
}

std::string expandTemplate(const std::string& text, const std::filesystem::path& model, const std::string& view) {
    return expandField(expandField(text, "{model}", model.stem().string()), "{view}", view);
}

// outputFiles() fills {map} of pictures.
std::filesystem::path outputOf(const RenderArguments& arguments, const View& view) {
    const std::string output = expandTemplate(arguments.output, arguments.model, view.name);
    return holdsLines(output) ? expandField(output, "{map}", "outline") : output;
}

std::vector<View> viewsFrom(const RenderArguments& arguments, const Settings& settings) {
    if (arguments.views.empty()) return {{"0", settings.camera}};
    std::vector<View> views = viewsOf(arguments.views, settings.camera);
    for (const auto& [flag, file] : {std::pair{"--output", arguments.output}, {"--metadata", arguments.metadataFile}}) {
        if (views.size() > 1 && !file.empty() && file.find("{view}") == std::string::npos)
            throw Error{Error::Kind::Usage,
                        fmt::format("{}: expected {{view}} in it for {} views, found '{}'", flag, views.size(), file)};
    }
    return views;
}

void checkStandardOutput(const RenderArguments& arguments, const Settings& settings) {
    if (arguments.output != "-") return;
    if (arguments.json) throw Error{Error::Kind::Usage, "--json: expected --output FILE, found - (both use stdout)"};
    if (!settings.maps.empty()) throw Error{Error::Kind::Usage, "--maps: expected --output FILE, found -"};
    if (!arguments.views.empty()) throw Error{Error::Kind::Usage, "--views: expected --output FILE, found -"};
}

// A folder that is missing fails before the work, and before another file is written.
void expectFolderOf(const std::filesystem::path& file) {
    const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;
    if (std::filesystem::is_directory(folder, ignored)) return;
    const bool exists = std::filesystem::exists(folder, ignored);
    throw Error{Error::Kind::Output,
                fmt::format("{}: cannot be written: expected a folder {}, found {}", file.string(), folder.string(),
                            exists ? "a file in its way; choose another place" : "none; create it first")};
}

// What makes no lines does not go into a file of lines.
void expectLinesOnly(const RenderArguments& arguments, const Settings& settings, const std::filesystem::path& output) {
    const auto refuseIf = [&](bool given, std::string_view flag, std::string_view why) {
        if (!given) return;
        throw Error{Error::Kind::Usage,
                    fmt::format("{0}: expected a picture as --output, found {1}, which {2}; write a "
                                ".png, or leave {0} out",
                                flag, arguments.output, why)};
    };
    refuseIf(!settings.maps.empty(), "--maps", "holds lines");
    refuseIf(settings.style.style != Style::Ink, "--style", "holds lines");
    refuseIf(!settings.detector.functions.empty(), "--function", "holds lines");
    refuseIf(!settings.lines.brush.empty() && output.extension() == ".svg", "--brush", "has no textures");
}

void checkOutputs(const RenderArguments& arguments, const Settings& settings, const View& view) {
    const std::filesystem::path output = outputOf(arguments, view);
    if (holdsLines(output)) {
        expectLinesOnly(arguments, settings, output);
        expectFolderOf(output);
    } else if (output != "-") {
        for (const auto& file : outputFiles(output, settings.maps)) expectFolderOf(file);
    }
    if (!arguments.metadataFile.empty())
        expectFolderOf(expandTemplate(arguments.metadataFile, arguments.model, view.name));
}

void startTimeout(const RenderArguments& arguments) {
    if (!arguments.timeout) return;
    limitTime(*arguments.timeout,
              fmt::format("inkedge: error: {}: expected the work to end within {} s, found it still going; raise "
                          "--timeout or ask for less (a smaller model, --size or --supersampling)\n",
                          arguments.model, *arguments.timeout));
}

void printSummary(const Maps& maps, const std::vector<std::filesystem::path>& files) {
    const BackendInfo& by = maps.backend;
    tell("", by.backend.empty()
                 ? std::string{"drawn without OpenGL"}
                 : fmt::format("drawn by {} ({}): {}, OpenGL {}", by.backend, by.platform, by.renderer, by.version));
    for (const StageTime& time : maps.times) tell("", fmt::format("{:>10} {:8.1f} ms", time.stage, time.milliseconds));
    for (const auto& file : files) tell("wrote ", file.string());
}

struct Summary {
    Maps maps;  // without their pixels
    std::vector<std::filesystem::path> files;
    nlohmann::ordered_json json;
};

// Draws one view and writes what is asked for.
Summary renderView(const RenderArguments& arguments, Settings settings, const Scene& scene, const View& view,
                   Renderer& renderer, const std::vector<StageTime>& before) {
    settings.camera = view.camera;
    const Camera camera = frameCamera(scene, settings.camera, settings.picture.size);
    Summary summary;
    const std::filesystem::path output = outputOf(arguments, view);
    Lines lines;
    Maps maps;
    if (holdsLines(output)) {
        lines = renderer.lines(scene, camera, settings);
        maps.backend = lines.backend;
        maps.times = lines.times;
    } else {
        maps = renderer.render(scene, camera, settings);
    }
    maps.times.insert(maps.times.begin(), before.begin(), before.end());

    const Stopwatch watch;
    if (holdsLines(output)) {
        writeLines(scene, lines, settings, output);
        summary.files = {output};
    } else if (output == "-") {
        const std::vector<std::uint8_t> png = encodePng(maps.picture);
        print({reinterpret_cast<const char*>(png.data()), png.size()});
    } else {
        summary.files = writeMaps(maps, settings.maps, output);
    }
    maps.times.push_back({"write", watch.milliseconds()});

    lines.times = maps.times;
    const std::string metadata =
        holdsLines(output) ? metadataJson(scene, lines, settings) : metadataJson(scene, maps, settings);
    if (!arguments.metadataFile.empty()) {
        writeFile(expandTemplate(arguments.metadataFile, arguments.model, view.name),
                  {reinterpret_cast<const std::uint8_t*>(metadata.data()), metadata.size()});
    }
    if (arguments.json) {
        summary.json = nlohmann::ordered_json::parse(metadata);
        summary.json["model"] = arguments.model;
        for (const auto& file : summary.files) summary.json["files"].push_back(file.string());
    }
    summary.maps.times = std::move(maps.times);
    summary.maps.backend = std::move(maps.backend);
    return summary;
}

// Views are drawn by several renderers at once, each with its pictures' encoding: a software driver leaves cores idle
// between its own threads, and a graphics processor while pictures are encoded. The first error ends the work.
class ViewPool {
public:
    using DrawView = std::function<Summary(std::size_t view, Renderer&)>;

    ViewPool(std::size_t views, DrawView draw) : draw_{std::move(draw)}, summaries_(views) {}

    std::vector<Summary> run(Renderer first, std::size_t workers, const BackendSettings& backend) {
        {
            std::vector<std::jthread> others;
            for (std::size_t i = 1; i < workers; ++i)
                others.emplace_back([&] {
                    guarded([&] {
                        Renderer renderer{backend, ContextTime::WhenNeeded};
                        work(renderer);
                    });
                });
            guarded([&] { work(first); });
        }
        if (failure_) std::rethrow_exception(failure_);
        return std::move(summaries_);
    }

private:
    void work(Renderer& renderer) {
        for (std::size_t view = next_++; view < summaries_.size(); view = next_++)
            summaries_[view] = draw_(view, renderer);
    }

    template <class Work>
    void guarded(Work&& work) {
        try {
            work();
        } catch (...) {
            next_ = summaries_.size();
            const std::scoped_lock lock{mutex_};
            if (!failure_) failure_ = std::current_exception();
        }
    }

    DrawView draw_;
    std::vector<Summary> summaries_;
    std::atomic<std::size_t> next_ = 0;
    std::mutex mutex_;
    std::exception_ptr failure_;
};

// A renderer costs a context and a copy of the scene on the graphics side: only for several views.
std::size_t workersFor(const RenderArguments& arguments, std::size_t views) {
    constexpr std::size_t viewsWorthAContext = 4;
    const std::size_t most = arguments.jobs > 0 ? static_cast<std::size_t>(arguments.jobs)
                                                : std::max(1U, std::thread::hardware_concurrency());
    return std::clamp<std::size_t>(views / viewsWorthAContext, 1, most);
}

void warn(const RenderArguments& arguments, const Settings& settings, const Scene& scene) {
    if (arguments.quiet) return;
    const auto hasNone = [](const Mesh& mesh) { return mesh.textureCoordinates.empty(); };
    const bool wantsIsolines = settings.lines.isolines != Isolines{} && loadSettings(settings).textureCoordinates;
    if (wantsIsolines && std::ranges::all_of(scene.meshes(), hasNone))
        tell("warning: ", fmt::format("{}: has no texture coordinates: no isolines are drawn", arguments.model));
    for (const std::string& warning : scene.warnings()) {
        tell("warning: ", fmt::format("{}: {}", arguments.model, warning));
    }
}

int render(const RenderArguments& arguments) {
    startTimeout(arguments);
    const Settings settings = arguments.settings.resolve();
    checkStandardOutput(arguments, settings);
    const std::vector<View> views = viewsFrom(arguments, settings);
    for (const View& view : views) checkOutputs(arguments, settings, view);

    const Stopwatch watch;
    const LoadSettings load = loadSettings(settings);
    const Scene scene = loadScene(arguments.model, load);
    const double loading = watch.milliseconds();
    std::vector<StageTime> before{{"load", loading - scene.preparationMilliseconds()},
                                  {"prepare", scene.preparationMilliseconds()}};
    warn(arguments, settings, scene);

    ViewPool pool{views.size(), [&](std::size_t view, Renderer& itsRenderer) {
                      return renderView(arguments, settings, scene, views[view], itsRenderer,
                                        view == 0 ? before : std::vector<StageTime>{});
                  }};
    const std::vector<Summary> summaries = pool.run(Renderer{settings.backend, ContextTime::WhenNeeded},
                                                    workersFor(arguments, views.size()), settings.backend);

    if (arguments.json) {
        nlohmann::ordered_json all = nlohmann::ordered_json::array();
        for (const Summary& summary : summaries) all.push_back(summary.json);
        constexpr auto replaceWhatIsNotUtf8 = nlohmann::ordered_json::error_handler_t::replace;
        const nlohmann::ordered_json& shown = arguments.views.empty() ? all.front() : all;
        print(shown.dump(2, ' ', false, replaceWhatIsNotUtf8) + "\n");
    }
    if (arguments.verbose)
        for (const Summary& summary : summaries) printSummary(summary.maps, summary.files);
    return 0;
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App* verb = app.add_subcommand("render", "Draw the outlines of a model.");
    verb->add_option("MODEL", arguments->model, "glTF 2.0, OBJ, STL or PLY file")->required();
    verb->add_option("-o,--output", arguments->output,
                     "picture to write, .png .tif .exr, or lines, .svg .json, or - for PNG on stdout; {model}, {view} "
                     "and {map} are filled in")
        ->required()
        ->type_name("FILE");
    verb->add_option("--metadata", arguments->metadataFile, "write camera, settings, backend and timings as JSON")
        ->type_name("FILE");
    verb->add_option(
            "--views", arguments->views,
            "draw several views: turntable:N, sphere:N, or a JSON list of camera settings; --output needs {view}")
        ->type_name("VIEWS");
    verb->add_option("--jobs", arguments->jobs, "views drawn at the same time [cores]")
        ->check(numberFrom(1, 1024))
        ->type_name("N");
    verb->add_option("--timeout", arguments->timeout, "end with exit status 1 if it takes longer")
        ->check(numberOver(0.0, longestTimeout))
        ->type_name("SECONDS");
    verb->add_flag("--json", arguments->json, "print the metadata and the files written on stdout");
    verb->add_flag("-q,--quiet", arguments->quiet, "no warnings");
    verb->add_flag("-v,--verbose", arguments->verbose, "say what drew the picture, the timings and the files written");
    arguments->settings.addTo(*verb);
    verb->callback([arguments, &action] { action = [arguments] { return render(*arguments); }; });
}

}  // namespace inkedge::cli
