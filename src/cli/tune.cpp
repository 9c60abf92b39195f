#include <memory>

#include <fmt/format.h>

#include <inkedge/error.h>

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

int tune(const TuneArguments& arguments) {
    const std::string& model = arguments.model.names().front();
    if (model == "-") throw Error{Error::Kind::Usage, "MODEL: expected a file, found -; it is read as often as needed"};
    tune::serve({.model = model,
                 .settings = arguments.settings.resolve(),
                 .port = arguments.port,
                 .waiting = [](const std::string& address) { print(address + "\n"); }});
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
    verb->callback([arguments, &action] { action = [arguments] { return tune(*arguments); }; });
}

}  // namespace inkedge::cli
