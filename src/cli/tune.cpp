#include <memory>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/message.h"
#include "cli/checks.h"
#include "cli/model_argument.h"
#include "cli/settings_sources.h"
#include "cli/streams.h"
#include "cli/verbs.h"
#include "tune/tune.h"

namespace inkedge::cli {
namespace {

struct TuneArguments {
    ModelArgument model;
    int port = 0;
    SettingsSources settings;
};

int runTune(const TuneArguments& arguments) {
    const std::string& model = arguments.model.names().front();
    if (model == "-") throw Error{Error::Kind::Usage, "MODEL: expected a file, found -; it is read as often as needed"};
    for (const std::string& name : SettingsSources::unknownVariables())
        report("warning: ", fmt::format("{} does nothing: no setting has this name", base::printable(name)));
    const auto waiting = [](const std::string& address) {
        print(address + "\n");
        report("", "open this address in a browser of this machine; Ctrl-C ends the page");
    };
    tune::serve({.model = model, .settings = arguments.settings.resolve(), .port = arguments.port, .waiting = waiting});
}

}  // namespace

void addTune(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<TuneArguments>();
    CLI::App* verb = app.add_subcommand("tune", "Try settings on a live page of this machine's browser.");
    arguments->model.addTo(*verb);
    verb->add_option("--port", arguments->port, "of 127.0.0.1 [any that is free]")
        ->check(numberFrom(0, 65535))
        ->type_name("N");
    arguments->settings.addTo(*verb);
    verb->callback([arguments, &action] { action = [arguments] { return runTune(*arguments); }; });
}

}  // namespace inkedge::cli
