#include <array>
#include <memory>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <inkedge/compare.h>
#include <inkedge/compare_lines.h>
#include <inkedge/error.h>

#include "cli/checks.h"
#include "cli/compare_lines.h"
#include "cli/settings_sources.h"
#include "cli/streams.h"
#include "cli/verbs.h"

namespace inkedge::cli {
namespace {

constexpr int picturesDiffer = 1;

struct CompareArguments {
    std::string a;
    std::string b;
    std::string differencePicture;
    std::optional<double> level;
    double share = 0.0;
    std::optional<double> hardLimit;
    std::optional<double> distance;
    std::optional<double> speck;
    bool lines = false;
    bool json = false;
    bool quiet = false;
    SettingsSources settings;
};

void expectNone(const std::optional<double>& given, std::string_view flag, std::string_view remedy) {
    if (given) throw Error{Error::Kind::Usage, fmt::format("{}: {}", flag, remedy)};
}

void warn(const CompareArguments& arguments, const std::vector<std::string>& warnings) {
    if (arguments.quiet) return;
    for (const std::string& warning : warnings) report("warning: ", warning);
}

std::optional<std::filesystem::path> differenceFile(const CompareArguments& arguments) {
    if (arguments.differencePicture.empty()) return {};
    return arguments.differencePicture;
}

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

int comparePictures(const CompareArguments& arguments) {
    expectNone(arguments.distance, "--distance", "expected it with --lines, found it without");
    expectNone(arguments.speck, "--speck", "expected it with --lines, found it without");
    warn(arguments, idleWithoutModels(arguments.settings));
    Tolerance tolerance{.level = arguments.level.value_or(0.0), .share = arguments.share};
    tolerance.hardLimit = arguments.hardLimit.value_or(tolerance.share > 0.0 ? unlimited : tolerance.level);
    const Comparison comparison = inkedge::compare(arguments.a, arguments.b, tolerance, differenceFile(arguments));
    if (arguments.json) {
        printJson(comparison);
    } else if (!arguments.quiet) {
        printText(comparison);
    }
    return comparison.same ? 0 : picturesDiffer;
}

int compareAsLines(const CompareArguments& arguments) {
    constexpr std::string_view forPixels = "expected it without --lines, found it with; --distance is what lines have";
    expectNone(arguments.level, "--level", forPixels);
    expectNone(arguments.hardLimit, "--hard-limit", forPixels);
    const std::array<std::filesystem::path, 2> files{arguments.a, arguments.b};
    if (const auto file = differenceFile(arguments)) expectComparisonFile(*file, files);
    LineTolerance tolerance{.share = arguments.share};
    tolerance.distance = arguments.distance.value_or(tolerance.distance);
    tolerance.speck = arguments.speck.value_or(tolerance.speck);
    const ComparedInputs inputs = readComparedInputs(arguments.a, arguments.b, arguments.settings);
    warn(arguments, inputs.warnings);
    tolerance.hidden = inputs.hidden;
    const LinesComparison comparison = compareLines(inputs.a, inputs.b, tolerance);
    if (const auto file = differenceFile(arguments)) writeComparison(comparison, *file);
    if (arguments.json) {
        print(comparisonJson(comparison));
    } else if (!arguments.quiet) {
        print(comparisonText(comparison));
    }
    return comparison.same ? 0 : picturesDiffer;
}

}  // namespace

void addCompare(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<CompareArguments>();
    CLI::App* verb = app.add_subcommand("compare",
                                        "Compare two pictures, or the lines of two drawings; exit status 1 when they "
                                        "differ.");
    verb->add_option("A", arguments->a, "a picture; with --lines also lines as .svg or .json, or a model")->required();
    verb->add_option("B", arguments->b, "another")->required();
    verb->add_option("-o,--output", arguments->differencePicture,
                     "write a picture of the differences; with --lines .svg, .pdf or .png: vanished lines are "
                     "vermilion, those that appeared blue, changed ones purple")
        ->type_name("DIFF");
    verb->add_option("--share", arguments->share,
                     "share of pixels that may lie over the level, or of the length of lines that may change, 0 to 1 "
                     "[0]")
        ->check(numberFrom(0.0, 1.0))
        ->type_name("SHARE");
    verb->add_option("--level", arguments->level, "differences up to this do not count, 0 to 1 [0]")
        ->check(numberFrom(0.0, unlimited))
        ->type_name("LEVEL");
    verb->add_option("--hard-limit", arguments->hardLimit,
                     "no pixel may differ by more than this [no limit where a share is allowed, else the level]")
        ->check(numberFrom(0.0, unlimited))
        ->type_name("LIMIT");
    verb->add_flag("--lines", arguments->lines,
                   "compare lines: which appeared, vanished, moved, or changed type or visibility");
    verb->add_option("--distance", arguments->distance, "lines this near are the same [1.5]; with --lines")
        ->check(numberOver(0.0, 100.0))
        ->type_name("PX");
    verb->add_option("--speck", arguments->speck, "changes shorter than this are left out [4]; with --lines")
        ->check(numberFrom(0.0, unlimited))
        ->type_name("PX");
    verb->add_flag("--json", arguments->json, "print the result as JSON");
    verb->add_flag("-q,--quiet", arguments->quiet, "print nothing");
    arguments->settings.addTo(*verb, [](const SettingDescription& row) { return actsOnComparedLines(row); });
    verb->callback([arguments, &action] {
        action = [arguments] { return arguments->lines ? compareAsLines(*arguments) : comparePictures(*arguments); };
    });
}

}  // namespace inkedge::cli
