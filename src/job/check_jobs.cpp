#include <algorithm>
#include <map>
#include <string_view>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/job.h>
#include <inkedge/setting_table.h>
#include <inkedge/write.h>

#include "job/file_names.h"

namespace inkedge {
namespace job {
namespace {

namespace fs = std::filesystem;

// A folder that is missing fails before the work, and before another file is written.
void expectFolderOf(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) return;
    const bool exists = fs::exists(folder, ignored);
    throw Error{Error::Kind::Output,
                fmt::format("{}: cannot be written: expected a folder {}, found {}", file.string(), folder.string(),
                            exists ? "a file in its way; choose another place" : "none; create it first")};
}

void expectViewIn(std::string_view flag, const std::string& file, std::size_t views) {
    if (views < 2 || file.find("{view}") != std::string::npos) return;
    throw Error{Error::Kind::Usage,
                fmt::format("{}: expected {{view}} in it for {} views, found '{}'", flag, views, file)};
}

// What makes no lines does not go into a file of lines.
void expectLinesOnly(const Job& job, const std::string& output, const View& view) {
    const Settings& settings = job.settings;
    const auto refuseIf = [&](bool given, std::string_view flag, std::string_view why) {
        if (!given) return;
        throw Error{Error::Kind::Usage,
                    fmt::format("{0}: expected a picture as --output, found {1}, which {2}; write a "
                                ".png, or leave {0} out",
                                flag, output, why)};
    };
    const bool hasPicture = !std::ranges::all_of(
        job.outputs, [&](const std::string& other) { return holdsLines(outputOf(job, other, view)); });
    refuseIf(!settings.maps.empty() && !hasPicture, "--maps", "holds lines");
    refuseIf(settings.style.style != Style::Ink, "--style", "holds lines");
    refuseIf(!settings.detector.functions.empty(), "--function", "holds lines");
    const bool isSvg = outputOf(job, output, view).extension() == ".svg";
    refuseIf(!settings.lines.brush.empty() && isSvg, "--brush", "has no textures");
}

struct Writer {
    std::size_t job;
    std::size_t view;
    friend bool operator==(const Writer&, const Writer&) = default;
};
using Writers = std::map<fs::path, Writer>;

void expectNoOther(std::span<const Job> jobs, const fs::path& file, const Writer& writer, Writers& writers) {
    const auto [found, isNew] = writers.emplace(file.lexically_normal(), writer);
    if (isNew || found->second == writer) return;
    const auto nameOf = [&](const Writer& each) {
        return fmt::format("view {} of {}", viewsOf(jobs[each.job])[each.view].name, jobs[each.job].model.string());
    };
    throw Error{Error::Kind::Usage,
                fmt::format("{}: expected a file for {} alone, found it asked for by {} too; put {{model}} and "
                            "{{view}} in its name",
                            file.string(), nameOf(found->second), nameOf(writer))};
}

void check(std::span<const Job> jobs, std::size_t number, Writers& writers) {
    const Job& job = jobs[number];
    validate(job.settings);
    const std::vector<View> views = viewsOf(job);
    for (const std::string& output : job.outputs) expectViewIn("--output", output, views.size());
    if (!job.metadata.empty()) expectViewIn("--metadata", job.metadata, views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        for (const std::string& output : job.outputs)
            if (holdsLines(outputOf(job, output, views[i]))) expectLinesOnly(job, output, views[i]);
        for (const fs::path& file : filesOf(job, views[i])) {
            expectFolderOf(file);
            expectNoOther(jobs, file, {number, i}, writers);
        }
    }
}

}  // namespace
}  // namespace job

void checkJobs(std::span<const Job> jobs) {
    job::Writers writers;
    for (std::size_t i = 0; i < jobs.size(); ++i) job::check(jobs, i, writers);
}

}  // namespace inkedge
