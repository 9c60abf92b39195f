#include <chrono>
#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <inkedge/renderer.h>
#include <inkedge/write.h>

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
    std::optional<double> timeout;  // seconds
    bool json = false;
    bool quiet = false;
    bool verbose = false;
    SettingsSources settings;
};

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point begin) {
    return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

// Fills {model} and {view}; {map} is filled by outputFiles().
std::string expandTemplate(std::string text, const std::filesystem::path& model) {
    const std::pair<std::string, std::string> fields[]{{"{model}", model.stem().string()}, {"{view}", "0"}};
    for (const auto& [field, value] : fields) {
        for (std::size_t at = 0; (at = text.find(field, at)) != std::string::npos; at += value.size()) {
            text.replace(at, field.size(), value);
        }
    }
    return text;
}

void checkStandardOutput(const RenderArguments& arguments, const Settings& settings) {
    if (arguments.output != "-") return;
    if (arguments.json) throw Error{Error::Kind::Usage, "--json: expected --output FILE, found - (both use stdout)"};
    if (!settings.maps.empty()) throw Error{Error::Kind::Usage, "--maps: expected --output FILE, found -"};
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

void checkOutputs(const RenderArguments& arguments, const Settings& settings, const std::filesystem::path& output) {
    if (output != "-") {
        for (const auto& file : outputFiles(output, settings.maps)) expectFolderOf(file);
    }
    if (!arguments.metadataFile.empty()) expectFolderOf(arguments.metadataFile);
}

void startTimeout(const RenderArguments& arguments) {
    if (!arguments.timeout) return;
    limitTime(*arguments.timeout,
              fmt::format("inkedge: error: {}: expected the work to end within {} s, found it still going; raise "
                          "--timeout or ask for less (a smaller model, --size or --supersampling)\n",
                          arguments.model, *arguments.timeout));
}

void printSummary(const Maps& maps, const std::vector<std::filesystem::path>& files) {
    tell("", fmt::format("drawn by {} ({}): {}, OpenGL {}", maps.backend.backend, maps.backend.platform,
                         maps.backend.renderer, maps.backend.version));
    for (const StageTime& time : maps.times) tell("", fmt::format("{:>10} {:8.1f} ms", time.stage, time.milliseconds));
    for (const auto& file : files) tell("wrote ", file.string());
}

int render(const RenderArguments& arguments) {
    startTimeout(arguments);
    const Settings settings = arguments.settings.resolve();
    checkStandardOutput(arguments, settings);
    const std::filesystem::path output = expandTemplate(arguments.output, arguments.model);
    checkOutputs(arguments, settings, output);

    auto begin = Clock::now();
    const Scene scene = loadScene(arguments.model, settings.load);
    const StageTime loading{"load", millisecondsSince(begin)};
    if (!arguments.quiet) {
        for (const std::string& warning : scene.warnings()) {
            tell("warning: ", fmt::format("{}: {}", arguments.model, warning));
        }
    }
    const Camera camera = frameCamera(scene, settings.camera, settings.picture.size);

    begin = Clock::now();
    Renderer renderer{settings.backend};
    const StageTime makingContext{"context", millisecondsSince(begin)};
    Maps maps = renderer.render(scene, camera, settings);
    maps.times.insert(maps.times.begin(), {loading, makingContext});

    begin = Clock::now();
    std::vector<std::filesystem::path> files;
    if (output == "-") {
        const std::vector<std::uint8_t> png = encodePng(maps.picture);
        print({reinterpret_cast<const char*>(png.data()), png.size()});
    } else {
        files = writeMaps(maps, settings.maps, output);
    }
    maps.times.push_back({"write", millisecondsSince(begin)});

    const std::string metadata = metadataJson(scene, maps, settings);
    if (!arguments.metadataFile.empty()) {
        writeFile(arguments.metadataFile, {reinterpret_cast<const std::uint8_t*>(metadata.data()), metadata.size()});
    }
    if (arguments.json) {
        nlohmann::ordered_json summary = nlohmann::ordered_json::parse(metadata);
        summary["model"] = arguments.model;
        for (const auto& file : files) summary["files"].push_back(file.string());
        constexpr auto replaceWhatIsNotUtf8 = nlohmann::ordered_json::error_handler_t::replace;
        print(summary.dump(2, ' ', false, replaceWhatIsNotUtf8) + "\n");
    }
    if (arguments.verbose) printSummary(maps, files);
    return 0;
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<RenderArguments>();
    CLI::App* verb = app.add_subcommand("render", "Draw the outlines of a model.");
    verb->add_option("MODEL", arguments->model, "glTF 2.0 file, .glb or .gltf")->required();
    verb->add_option(
            "-o,--output", arguments->output,
            "picture to write, .png .tif .exr, or - for PNG on stdout; {model}, {view} and {map} are filled in")
        ->required()
        ->type_name("FILE");
    verb->add_option("--metadata", arguments->metadataFile, "write camera, settings, backend and timings as JSON")
        ->type_name("FILE");
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
