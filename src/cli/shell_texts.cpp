#include <memory>
#include <string>

#include <fmt/format.h>

#include "cli/checks.h"
#include "cli/completion.h"
#include "cli/manual_page.h"
#include "cli/streams.h"
#include "cli/verbs.h"

namespace inkedge::cli {

void addCompletion(CLI::App& app, Action& action) {
    const auto shell = std::make_shared<std::string>();
    CLI::App* verb = app.add_subcommand("completion", "Print a script that completes what is typed in a shell.");
    verb->add_option("SHELL", *shell, "the shell")
        ->required()
        ->check(oneOf({"bash", "zsh", "fish"}))
        ->type_name("bash|zsh|fish");
    verb->callback([&app, &action, shell] {
        action = [&app, shell] {
            const std::vector<VerbText> verbs = verbsOf(app);
            print(*shell == "bash"  ? bashCompletion(verbs)
                  : *shell == "zsh" ? zshCompletion(verbs)
                                    : fishCompletion(verbs));
            return 0;
        };
    });
}

void addManual(CLI::App& app, Action& action) {
    CLI::App* verb = app.add_subcommand("manual", "Print the manual page, to be read by man -l.");
    verb->callback([&app, &action] {
        action = [&app] {
            print(manualPage(app.get_description(), verbsOf(app)));
            return 0;
        };
    });
}

}  // namespace inkedge::cli
