// Turns outcomes into exit codes: 0 success, 1 to 5 an Error's kind, 1 also when pictures differ or time is over, 128
// and the signal's number when interrupted.
#include <algorithm>
#include <exception>
#include <new>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <inkedge/error.h>
#include <inkedge/load_scene.h>
#include <inkedge/version.h>

#include "base/file_extension.h"
#include "base/nearest_name.h"
#include "cli/streams.h"
#include "cli/verbs.h"
#include "process/large_pages.h"
#include "process/signals.h"

namespace {

constexpr int runtimeFailure = static_cast<int>(inkedge::Error::Kind::Runtime);
constexpr int usageFailure = static_cast<int>(inkedge::Error::Kind::Usage);

int report(std::string_view message, int exitCode) {
    inkedge::cli::report("error: ", message);
    return exitCode;
}

// The flag of a verb that a misspelt one stands for; empty: none.
std::string nearestFlag(const CLI::App& verb, const std::string& text) {
    std::vector<std::string_view> flags;
    for (const CLI::Option* option : verb.get_options())
        for (const std::string& name : option->get_lnames()) flags.push_back(name);
    if (!text.starts_with("--")) return {};
    const std::string nearest = inkedge::base::nearestName(text.substr(2, text.find('=') - 2), flags);
    return nearest.empty() ? nearest : "--" + nearest;
}

bool namesModel(const std::string& text) {
    const std::string extension = inkedge::base::lowerCaseExtension(text);
    return std::ranges::any_of(inkedge::readableFormats(), [&](const inkedge::ModelFormat& format) {
        return std::ranges::find(format.extensions, extension) != format.extensions.end();
    });
}

// What to do where no verb is given, or none that there is.
std::string explainVerb(const CLI::App& app, const std::vector<std::string>& unknown) {
    std::vector<std::string> verbs;
    for (const CLI::App* verb : app.get_subcommands({}))
        if (!verb->get_group().empty()) verbs.push_back(verb->get_name());
    const std::string last = verbs.back();
    const std::string expected =
        fmt::format("expected {} or {}, found ", fmt::join(verbs.begin(), verbs.end() - 1, ", "), last);
    if (unknown.empty()) return expected + "nothing; see inkedge --help";
    const std::string& found = unknown.front();
    if (namesModel(found))
        return fmt::format("{}the model '{}'; put render before it: inkedge render {} -o FILE", expected, found, found);
    const std::vector<std::string_view> names{verbs.begin(), verbs.end()};
    const std::string nearest = inkedge::base::nearestName(found, names);
    return fmt::format("{}'{}'; {}see inkedge --help", expected, found,
                       nearest.empty() ? nearest : fmt::format("is it {}? ", nearest));
}

// An error of the command line in the words of all our errors, or in the parser's own words if we have none for it.
std::string explain(const CLI::App& app, const CLI::ParseError& error) {
    const auto verbs = app.get_subcommands();
    const std::vector<std::string> unknown = app.remaining(true);
    const std::string text = error.what();
    if (verbs.empty()) return explainVerb(app, unknown);
    const std::string remedy = fmt::format("see inkedge {} --help", verbs.front()->get_name());
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr && !unknown.empty()) {
        const std::string nearest = nearestFlag(*verbs.front(), unknown.front());
        return fmt::format("expected what inkedge {} takes, found '{}'; {}{}", verbs.front()->get_name(),
                           unknown.front(), nearest.empty() ? "" : fmt::format("is it {}? ", nearest), remedy);
    }
    constexpr std::string_view required = " is required";
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr && text.ends_with(required)) {
        return fmt::format("expected {}, found none; {}", text.substr(0, text.size() - required.size()), remedy);
    }
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) {
        return fmt::format("{}: expected one value, found {}; {}", text.substr(0, text.find(':')),
                           text.ends_with("missing") ? "none" : "several", remedy);
    }
    return fmt::format("{}; {}", text, remedy);
}

int run(CLI::App& app, int argc, char** argv) {
    inkedge::cli::Action action;
    inkedge::cli::addRender(app, action);
    inkedge::cli::addBatch(app, action);
    inkedge::cli::addGallery(app, action);
    inkedge::cli::addSheet(app, action);
    inkedge::cli::addTune(app, action);
    inkedge::cli::addCompare(app, action);
    inkedge::cli::addInspect(app, action);
    inkedge::cli::addDoctor(app, action);
    inkedge::cli::addCompletion(app, action);
    inkedge::cli::addManual(app, action);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& helpOrVersion) {
        std::ostringstream text;
        app.exit(helpOrVersion, text, text);
        inkedge::cli::print(text.str());
        return 0;
    } catch (const CLI::ParseError& error) {
        return report(explain(app, error), usageFailure);
    }
    return action();
}

}  // namespace

int main(int argc, char** argv) {
    inkedge::process::useLargePages();
    inkedge::cli::holdStandardStreams();
    inkedge::process::handleSignals();
    CLI::App app{"Clean line drawings of 3D models, without a screen.", "inkedge"};
    app.set_version_flag("--version", fmt::format("inkedge {}", inkedge::version()));
    app.require_subcommand(1);
    try {
        return run(app, argc, argv);
    } catch (const inkedge::Error& error) {
        return report(error.what(), static_cast<int>(error.kind()));
    } catch (const std::bad_alloc&) {
        return report("expected enough memory, found too little; use a smaller model or --size", runtimeFailure);
    } catch (const std::exception& error) {
        return report(fmt::format("expected the work to come to its end, found: {}; report this, please", error.what()),
                      runtimeFailure);
    }
}
