#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <inkedge/compare.h>

#include "cli/checks.h"
#include "cli/streams.h"
#include "cli/verbs.h"

namespace inkedge::cli {
namespace {

constexpr int picturesDiffer = 1;

struct CompareArguments {
    std::string a;
    std::string b;
    std::string differencePicture;
    Tolerance tolerance;
    std::optional<double> hardLimit;
    bool json = false;
    bool quiet = false;
};

void printJson(const Comparison& c) {
    const nlohmann::ordered_json json{{"same", c.same},
                                      {"width", c.size.width},
                                      {"height", c.size.height},
                                      {"channels", c.channels},
                                      {"pixels_over_level", c.pixelsOverLevel},
                                      {"share_over_level", c.shareOverLevel},
                                      {"maximum", c.maximum},
                                      {"maximum_at", {c.maximumX, c.maximumY}},
                                      {"mean", c.mean}};
    print(json.dump(2) + "\n");
}

void printText(const Comparison& c) {
    print(
        fmt::format("{}: {} of {} pixels over the level ({:.4f} %), largest difference {:.4g} at {},{}, mean {:.4g}\n",
                    c.same ? "same" : "different", c.pixelsOverLevel,
                    static_cast<std::uint64_t>(c.size.width) * static_cast<std::uint64_t>(c.size.height),
                    100.0 * c.shareOverLevel, c.maximum, c.maximumX, c.maximumY, c.mean));
}

int compare(const CompareArguments& arguments) {
    std::optional<std::filesystem::path> differencePicture;
    if (!arguments.differencePicture.empty()) differencePicture = arguments.differencePicture;
    Tolerance tolerance = arguments.tolerance;
    tolerance.hardLimit = arguments.hardLimit.value_or(tolerance.share > 0.0 ? unlimited : tolerance.level);
    const Comparison comparison = inkedge::compare(arguments.a, arguments.b, tolerance, differencePicture);
    if (arguments.json) {
        printJson(comparison);
    } else if (!arguments.quiet) {
        printText(comparison);
    }
    return comparison.same ? 0 : picturesDiffer;
}

}  // namespace

void addCompare(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<CompareArguments>();
    CLI::App* verb = app.add_subcommand("compare", "Compare two pictures; exit status 1 when they differ.");
    verb->add_option("A", arguments->a, "a picture")->required();
    verb->add_option("B", arguments->b, "another")->required();
    verb->add_option("-o,--output", arguments->differencePicture, "write a picture of the differences")
        ->type_name("DIFF");
    verb->add_option("--level", arguments->tolerance.level, "differences up to this do not count, 0 to 1 [0]")
        ->check(numberFrom(0.0, unlimited))
        ->type_name("LEVEL");
    verb->add_option("--share", arguments->tolerance.share, "share of pixels that may lie over the level, 0 to 1 [0]")
        ->check(numberFrom(0.0, 1.0))
        ->type_name("SHARE");
    verb->add_option("--hard-limit", arguments->hardLimit,
                     "no pixel may differ by more than this [no limit where a share is allowed, else the level]")
        ->check(numberFrom(0.0, unlimited))
        ->type_name("LIMIT");
    verb->add_flag("--json", arguments->json, "print counts and maxima as JSON");
    verb->add_flag("-q,--quiet", arguments->quiet, "print nothing");
    verb->callback([arguments, &action] { action = [arguments] { return compare(*arguments); }; });
}

}  // namespace inkedge::cli
