#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/job.h>
#include <inkedge/load_scene.h>
#include <inkedge/renderer.h>
#include <inkedge/sheet.h>

#include "base/message.h"
#include "cli/checks.h"
#include "cli/model_argument.h"
#include "cli/progress.h"
#include "cli/settings_sources.h"
#include "cli/streams.h"
#include "cli/verbs.h"
#include "process/signals.h"

namespace inkedge::cli {
namespace {

struct SheetArguments {
    ModelArgument model;
    std::string output;
    std::vector<std::string> values;  // of sheetOptions()
    std::vector<CLI::Option*> options;
    std::optional<double> timeout;  // seconds
    bool quiet = false;
    SettingsSources settings;
};

// Whether a sheet is drawn with a setting: it is about the model, or lines and their pens.
bool usesSetting(const SettingDescription& row) {
    using namespace std::string_view_literals;
    constexpr std::array others{"hidden"sv, "lines-from"sv, "stroke-width"sv, "stroke-taper"sv, "brush"sv};
    constexpr std::array pens{"lines"sv, "line-style"sv, "line-width"sv, "line-color"sv, "background"sv, "dpi"sv};
    if (row.group == "lines") return std::ranges::find(others, row.name) == others.end();
    if (row.group == "picture") return std::ranges::find(pens, row.name) != pens.end();
    return row.group == "model" || row.group == "limits";
}

// What a preset, a configuration file or the environment sets in vain.
void warnOfIdleSettings(const Settings& settings) {
    const Settings defaults;
    for (const SettingDescription& row : settingTable()) {
        if (!usesSetting(row) && row.get(settings) != row.get(defaults))
            report("warning: ", fmt::format("--{} does nothing: it is for inkedge render", row.name));
    }
}

SheetSettings sheetSettings(const SheetArguments& arguments) {
    SheetSettings settings;
    for (std::size_t i = 0; i < arguments.options.size(); ++i)
        if (arguments.options[i]->count() > 0) sheetOptions()[i].set(settings, arguments.values[i]);
    return settings;
}

void expectNotRead(const std::filesystem::path& output, const Scene& scene) {
    for (const std::filesystem::path& file : scene.source().files) {
        std::error_code ignored;
        if (std::filesystem::equivalent(file, output, ignored))
            throw Error{Error::Kind::Usage,
                        fmt::format("{}: expected an output other than what is read, found a file of the model; choose "
                                    "another name",
                                    output.string())};
    }
}

int drawSheet(const SheetArguments& arguments) {
    if (arguments.timeout) {
        process::limitTime(
            *arguments.timeout,
            fmt::format("inkedge: error: {}: expected the work to end within {} s, found it still going; "
                        "raise --timeout or ask for fewer --views\n",
                        base::printable(arguments.model.names().front()), *arguments.timeout));
    }
    const SheetSettings wanted = sheetSettings(arguments);
    expectSheetFile(arguments.output);
    Job job{.model = {}, .settings = arguments.settings.resolve(), .outputs = {arguments.output}};
    Progress progress{arguments.model.names().front(), 1, !arguments.quiet};
    const GivenModel model = std::move(arguments.model.models(job.settings.load.limits).front());
    job.model = model.name;
    job.bytes = model.content();
    if (!arguments.settings.configFile().empty()) job.inputs = {arguments.settings.configFile()};
    const auto warn = [&](const std::string& text) {
        if (!arguments.quiet) report("warning: ", text);
    };
    const auto warnOfModel = [&](const std::string& text) { warn(fmt::format("{}: {}", model.name.string(), text)); };
    if (!arguments.quiet) warnOfIdleSettings(job.settings);
    const Settings settings = job.settings;
    job.settings = {};  // names of files alone are checked: a sheet draws nothing that its files could not hold
    checkJobs({&job, 1});
    const Scene scene = model.bytes ? loadScene(*model.bytes, model.name, loadSettings(settings))
                                    : loadScene(model.name, loadSettings(settings));
    progress.modelRead();
    const std::filesystem::path output = filesOf(job, {"sheet", {}}).front();
    expectNotRead(output, scene);
    std::ranges::for_each(scene.warnings(), warnOfModel);
    Renderer renderer{{}, ContextTime::WhenNeeded};
    const Sheet sheet = inkedge::drawSheet(renderer, scene, settings, wanted);
    std::ranges::for_each(sheet.warnings, warn);
    writeSheet(sheet, output);
    return 0;
}

}  // namespace

void addSheet(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<SheetArguments>();
    CLI::App* verb = app.add_subcommand("sheet", "Draw several views of a model on one page, as workshops read them.");
    arguments->model.addTo(*verb);
    verb->add_option("-o,--output", arguments->output,
                     "sheet to write, .pdf .svg .dxf .png (at --dpi, or 150); {model} is filled in")
        ->type_name("FILE")
        ->required();
    arguments->values.resize(sheetOptions().size());
    for (std::size_t i = 0; i < sheetOptions().size(); ++i) {
        const SheetOption& option = sheetOptions()[i];
        const std::string help =
            option.byDefault.empty() ? std::string{option.help} : fmt::format("{} [{}]", option.help, option.byDefault);
        arguments->options.push_back(verb->add_option(fmt::format("--{}", option.name), arguments->values[i], help)
                                         ->type_name(std::string{option.values}));
    }
    verb->add_option("--timeout", arguments->timeout, "end with exit status 1 if it takes longer")
        ->check(numberOver(0.0, process::longestTimeout))
        ->type_name("SECONDS");
    verb->add_flag("-q,--quiet", arguments->quiet, "no warnings");
    arguments->settings.addTo(*verb, usesSetting);
    verb->callback([arguments, &action] { action = [arguments] { return drawSheet(*arguments); }; });
}

}  // namespace inkedge::cli
