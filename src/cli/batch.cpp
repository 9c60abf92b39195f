#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <inkedge/error.h>
#include <inkedge/job.h>

#include "base/message.h"
#include "batch/batch.h"
#include "batch/portion.h"
#include "cli/checks.h"
#include "cli/settings_sources.h"
#include "cli/streams.h"
#include "cli/verbs.h"
#include "process/driver_threads.h"
#include "process/signals.h"

namespace inkedge::cli {
namespace {

using batch::Batch;
using batch::Counts;

struct BatchArguments {
    Batch batch;
    std::string formats = "png";
    std::string shard;      // I/N; empty: as a scheduler says, or all
    std::string shards;     // N, or N and MB or GB; empty: folders
    std::string maxMemory;  // likewise; empty: a share of the machine's
    std::optional<double> timeout;
    bool json = false;
    bool quiet = false;
    SettingsSources settings;
};

struct Amount {
    std::uint64_t number = 0;
    std::string_view unit;
};

// "500MB", "1000"; a number over 0.
std::optional<Amount> amountOf(std::string_view text) {
    Amount amount;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), amount.number);
    if (error != std::errc{} || amount.number == 0 || amount.number > 1'000'000'000'000) return {};
    amount.unit = text.substr(static_cast<std::size_t>(end - text.data()));
    return amount;
}

std::optional<std::uint64_t> bytesIn(std::string_view unit) {
    if (unit == "MB") return 1'000'000;
    if (unit == "GB") return 1'000'000'000;
    return {};
}

batch::ShardSize shardSize(const std::string& text) {
    const std::optional<Amount> amount = amountOf(text);
    if (amount && amount->unit.empty()) return {.items = amount->number};
    if (amount && bytesIn(amount->unit)) return {.bytes = amount->number * *bytesIn(amount->unit)};
    throw Error{
        Error::Kind::Usage,
        fmt::format("--shards: expected a number of items, or of MB or GB, as 1000 or 500MB, found '{}'", text)};
}

std::uint64_t memorySize(const std::string& text) {
    if (const std::optional<Amount> amount = amountOf(text); amount && bytesIn(amount->unit))
        return amount->number * *bytesIn(amount->unit);
    throw Error{Error::Kind::Usage,
                fmt::format("--max-memory: expected a number of MB or GB, as 2GB, found '{}'", text)};
}

std::vector<std::string> formatsIn(const std::string& text) {
    std::vector<std::string> formats;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        formats.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return formats;
}

std::string clock(double seconds) {
    const auto whole = static_cast<std::uint64_t>(seconds + 0.5);
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string progressLine(const batch::Progress& progress) {
    const Counts& counts = progress.counts;
    std::string line = fmt::format("{}", counts.done());
    if (progress.items) line += fmt::format(" of {}", *progress.items);
    line += fmt::format(" items, {} failed, {:.1f}/s", counts.failures(), progress.rate);
    if (progress.left) line += fmt::format(", {} left", clock(*progress.left));
    return line;
}

// On a terminal one line that changes, elsewhere a line a minute.
class ProgressReport {
public:
    explicit ProgressReport(bool quiet) : quiet_{quiet} {}

    void show(const batch::Progress& progress) {
        constexpr std::chrono::minutes betweenLines{1};
        if (quiet_) return;
        if (showsStatus()) return showStatus(progressLine(progress));
        if (const auto now = std::chrono::steady_clock::now(); now - last_ >= betweenLines) {
            last_ = now;
            report("", progressLine(progress));
        }
    }
    void showFailure(const std::string& message) {
        if (!quiet_) report("error: ", message);
    }
    void hide() {
        if (!quiet_ && showsStatus()) showStatus({});
    }

private:
    bool quiet_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::string failuresText(const Counts& counts) {
    std::vector<std::string> parts;
    for (std::size_t i = 1; i < batch::stateNames.size(); ++i)
        if (const std::uint64_t count = counts.now[i] + counts.before[i]; count > 0)
            parts.push_back(fmt::format("{} {}", count, batch::stateNames[i]));
    if (counts.badLines > 0) parts.push_back(fmt::format("{} no items", counts.badLines));
    return parts.empty() ? std::string{} : fmt::format(" ({})", fmt::join(parts, ", "));
}

void printSummary(const batch::Progress& progress) {
    const Counts& counts = progress.counts;
    std::string line = fmt::format("{} items: {} drawn", counts.done(), counts.now.front());
    if (counts.before.front() > 0) line += fmt::format(", {} drawn before", counts.before.front());
    const double rate = progress.seconds > 0.0 ? static_cast<double>(counts.done()) / progress.seconds : 0.0;
    print(fmt::format("{}, {} failed{} in {}, {:.1f}/s\n", line, counts.failures(), failuresText(counts),
                      clock(progress.seconds), rate));
}

void printJson(const batch::Progress& progress) {
    const Counts& counts = progress.counts;
    nlohmann::ordered_json json{{"items", counts.done()},
                                {"failed", counts.failures()},
                                {"bad_lines", counts.badLines},
                                {"seconds", progress.seconds}};
    for (std::size_t i = 0; i < batch::stateNames.size(); ++i) {
        const std::string name{batch::stateNames[i]};
        json["now"][name] = counts.now[i];
        json["before"][name] = counts.before[i];
    }
    print(json.dump(2) + "\n");
}

Batch batchOf(const BatchArguments& arguments) {
    Batch batch = arguments.batch;
    batch.settings = arguments.settings.resolve();
    batch.formats = formatsIn(arguments.formats);
    batch.portion = batch::portionOf(arguments.shard, [](const char* name) { return std::getenv(name); });
    if (!arguments.shards.empty()) batch.shards = shardSize(arguments.shards);
    if (!arguments.maxMemory.empty()) batch.maxMemory = memorySize(arguments.maxMemory);
    if (arguments.timeout) batch.timeout = *arguments.timeout;
    batch.program = std::filesystem::read_symlink("/proc/self/exe");
    return batch;
}

void warnOfIdleSettings(const Batch& batch) {
    Job job{.model = "model", .settings = batch.settings};
    for (const std::string& format : batch.formats) job.outputs.push_back("{view}.{map}." + format);
    if (!batch.views.empty()) job.views = viewsOf(batch.views, batch.settings.camera);
    for (const std::string& line : idleSettings(job)) report("warning: ", line);
    for (const std::string& name : SettingsSources::unknownVariables())
        report("warning: ", fmt::format("{} does nothing: no setting has this name", base::printable(name)));
}

int runBatch(const BatchArguments& arguments) {
    const Batch batch = batchOf(arguments);
    if (!arguments.quiet) {
        warnOfIdleSettings(batch);
        if (batch.portion.count > 1)
            report("", fmt::format("items of shard {}/{}", batch.portion.index, batch.portion.count));
    }
    ProgressReport shown{arguments.quiet};
    const batch::Progress end =
        batch::runBatch(batch, {.progress = [&](const batch::Progress& progress) { shown.show(progress); },
                                .failed = [&](const std::string& message) { shown.showFailure(message); }});
    shown.hide();
    arguments.json ? printJson(end) : printSummary(end);
    if (batch.maxFailures && end.counts.newFailures() > *batch.maxFailures)
        throw Error{Error::Kind::Runtime,
                    fmt::format("expected at most {} failures, found {}; the results in {} say why", *batch.maxFailures,
                                end.counts.newFailures(), batch.output.string())};
    return end.counts.failures() > 0 ? 1 : 0;
}

void addFlags(CLI::App& verb, BatchArguments& arguments) {
    Batch& batch = arguments.batch;
    verb.add_option("INPUT", batch.input,
                    "folder of models, or file of items, a line each: a path, or JSON with model and, as they are "
                    "needed, id, views and settings; - for stdin")
        ->required();
    verb.add_option("-o,--output", batch.output,
                    "folder to write: results.jsonl, and a folder for each item, or shards")
        ->required()
        ->type_name("FOLDER");
    verb.add_option("--views", batch.views, "views of each model, as inkedge render takes them")->type_name("VIEWS");
    verb.add_option("--formats", arguments.formats, "of the files: png, tif, exr, npz, svg, pdf, dxf, json [png]")
        ->type_name("FORMAT,...");
    verb.add_option("--shards", arguments.shards, "write tars of so many items, or up to a size, instead of folders")
        ->type_name("N|SIZE");
    verb.add_option(
            "--shard", arguments.shard,
            "draw one of N portions of the items, I from 0; auto/N: by the number of a task of Slurm, Kubernetes "
            "or AWS Batch [likewise, where they say N; else all]")
        ->type_name("I/N");
    verb.add_option("--jobs", batch.jobs, "worker processes [cores]")->check(numberFrom(1, 1024))->type_name("N");
    verb.add_option("--timeout", arguments.timeout, "of an item [300]")
        ->check(numberOver(0.0, process::longestTimeout))
        ->type_name("SECONDS");
    verb.add_option("--max-memory", arguments.maxMemory, "of a worker [memory / jobs]")->type_name("SIZE");
    verb.add_option("--max-failures", batch.maxFailures, "end once more items than this have failed")->type_name("N");
    verb.add_flag("--score", batch.score,
                  "say of each item how far lines between pixels and lines of the mesh agree: precision, recall, F1");
    verb.add_flag("--retry", batch.retry, "draw anew what failed in an earlier run, whatever the reason");
    verb.add_flag("--json", arguments.json, "print the summary as JSON");
    verb.add_flag("-q,--quiet", arguments.quiet, "no progress, warnings and failures on stderr");
    arguments.settings.addTo(verb);
}

}  // namespace

void addBatch(CLI::App& app, Action& action) {
    const auto arguments = std::make_shared<BatchArguments>();
    CLI::App* verb = app.add_subcommand("batch", "Draw many models, by several processes, and go on where it ended.");
    addFlags(*verb, *arguments);
    verb->callback([arguments, &action] { action = [arguments] { return runBatch(*arguments); }; });

    CLI::App* worker = app.add_subcommand(std::string{batch::workerVerb})->group("");  // not for people
    worker->callback([&action] {
        action = []() -> int {
            process::drawInCallingThreads();
            batch::work();
        };
    });
}

}  // namespace inkedge::cli
