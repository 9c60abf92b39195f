#include "batch/portion.h"

#include <charconv>
#include <optional>

#include <fmt/format.h>

#include <inkedge/error.h>

#include "base/content_hash.h"
#include "base/message.h"

namespace inkedge::batch {
namespace {

constexpr std::uint64_t maxPortions = 1'000'000;

[[noreturn]] void refuse(const std::string& message) { throw Error{Error::Kind::Usage, message}; }

std::optional<std::uint64_t> numberIn(std::string_view text) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc{} || end != text.data() + text.size()) return {};
    return number;
}

// A number that a scheduler has set.
std::uint64_t numberOf(const Environment& environment, const char* name) {
    const char* const text = environment(name);
    const std::optional<std::uint64_t> number = numberIn(text == nullptr ? "" : text);
    if (!number)
        refuse(fmt::format("{}: expected a whole number, found {}; give --shard I/N", name,
                           text == nullptr ? "none" : base::quote(text)));
    return *number;
}

// What a scheduler says of a task: which of how many.
struct Task {
    const char* variable;
    std::uint64_t index = 0;
    std::optional<std::uint64_t> count = {};
};

// Of a list, as --array=3,7,11, Slurm gives the number of tasks, the smallest and the largest id, and a step of 1:
// which of them a task is cannot be known.
Task slurmTask(const Environment& environment) {
    const std::uint64_t id = numberOf(environment, "SLURM_ARRAY_TASK_ID");
    const std::uint64_t first = numberOf(environment, "SLURM_ARRAY_TASK_MIN");
    const std::uint64_t last = numberOf(environment, "SLURM_ARRAY_TASK_MAX");
    const std::uint64_t count = numberOf(environment, "SLURM_ARRAY_TASK_COUNT");
    const std::uint64_t step = numberOf(environment, "SLURM_ARRAY_TASK_STEP");
    const bool even = step > 0 && count > 0 && first <= last && (last - first) / step + 1 == count &&
                      (last - first) % step == 0 && first <= id && id <= last && (id - first) % step == 0;
    if (!even)
        refuse(
            fmt::format("SLURM_ARRAY_TASK_ID: expected a task of an array in even steps, as --array=0-7, found {} "
                        "of {} from {} to {}: which of them it is cannot be known; give --shard I/N",
                        id, count, first, last));
    return {"SLURM_ARRAY_TASK_ID", (id - first) / step, count};
}

std::optional<Task> taskOf(const Environment& environment) {
    if (environment("SLURM_ARRAY_TASK_ID") != nullptr) return slurmTask(environment);
    if (const char* const name = "AWS_BATCH_JOB_ARRAY_INDEX"; environment(name) != nullptr) {
        Task task{name, numberOf(environment, name)};
        if (environment("AWS_BATCH_JOB_ARRAY_SIZE") != nullptr)
            task.count = numberOf(environment, "AWS_BATCH_JOB_ARRAY_SIZE");
        return task;
    }
    // Kubernetes does not say how many there are.
    if (const char* const name = "JOB_COMPLETION_INDEX"; environment(name) != nullptr)
        return Task{name, numberOf(environment, name)};
    return {};
}

Portion portionOf(const Task& task, std::optional<std::uint64_t> count) {
    if (!task.count && !count)
        refuse(fmt::format("{}: expected --shard auto/N beside it, N the number of tasks, found none", task.variable));
    if (task.count && count && *task.count != *count)
        refuse(
            fmt::format("--shard: expected auto/{}, as {} has it, found auto/{}", *task.count, task.variable, *count));
    const Portion portion{task.index, count ? *count : *task.count};
    if (portion.index >= portion.count)
        refuse(fmt::format("{}: expected a number under {}, found {}", task.variable, portion.count, portion.index));
    return portion;
}

}  // namespace

bool holds(const Portion& portion, std::string_view id) noexcept {
    return portion.count == 1 || base::hashOf(id) % portion.count == portion.index;
}

std::string nameOf(const Portion& portion) {
    if (portion.count == 1) return {};
    const std::string count = std::to_string(portion.count);
    return fmt::format("{:0{}}-of-{}", portion.index, count.size(), count);
}

Portion portionOf(std::string_view text, const Environment& environment) {
    if (text.empty()) {
        const std::optional<Task> task = taskOf(environment);
        return task ? portionOf(*task, {}) : Portion{};
    }
    const std::size_t slash = text.find('/');
    const std::string_view index = text.substr(0, slash);
    const std::optional<std::uint64_t> count =
        slash == std::string_view::npos ? std::nullopt : numberIn(text.substr(slash + 1));
    const bool countable = count && *count > 0 && *count <= maxPortions;
    if (countable && index == "auto") {
        const std::optional<Task> task = taskOf(environment);
        if (!task)
            refuse(
                "--shard: expected auto in a task of Slurm, Kubernetes or AWS Batch, found none of their variables; "
                "give I/N");
        return portionOf(*task, count);
    }
    const std::optional<std::uint64_t> number = numberIn(index);
    if (!countable || !number || *number >= *count)
        refuse(fmt::format("--shard: expected I/N, I from 0 to N - 1, or auto/N, found '{}'", text));
    return {*number, *count};
}

}  // namespace inkedge::batch
