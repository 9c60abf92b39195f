#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/job.h>
#include <inkedge/setting_table.h>
#include <inkedge/write.h>

#include "base/staged_files.h"
#include "io/output_formats.h"
#include "job/file_names.h"
#include "job/files_apart.h"

namespace inkedge {
namespace job {
namespace {

namespace fs = std::filesystem;

// What cannot be written fails before the work, and before another file is written.
void expectFolderFor(const fs::path& file) {
    const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) return static_cast<void>(base::destinationOf(file));
    const bool exists = fs::exists(folder, ignored);
    throw Error{Error::Kind::Output,
                fmt::format("{}: cannot be written: expected a folder {}, found {}", file.string(), folder.string(),
                            exists ? "a file in its way; choose another place" : "none; create it first")};
}

void expectViewIn(const std::string& output, std::size_t views) {
    if (views < 2 || output.find("{view}") != std::string::npos) return;
    throw Error{Error::Kind::Usage,
                fmt::format("--output: expected {{view}} in it for {} views, found '{}'", views, output)};
}

// What makes no lines does not go into a file of lines.
void expectLinesOnly(const Job& job, const std::string& output) {
    const Settings& settings = job.settings;
    const auto refuseIf = [&](bool given, std::string_view flag, std::string_view why) {
        if (!given) return;
        throw Error{Error::Kind::Usage,
                    fmt::format("{0}: expected a picture as --output, found {1}, which {2}; write a "
                                ".png, or leave {0} out",
                                flag, output, why)};
    };
    const bool hasPicture =
        !std::ranges::all_of(job.outputs, [](const std::string& other) { return holdsLines(other); });
    refuseIf(!settings.maps.empty() && !hasPicture, "--maps", "holds lines");
    refuseIf(settings.style.style != Style::Ink, "--style", "holds lines");
    refuseIf(!settings.detector.functions.empty(), "--function", "holds lines");
    refuseIf(!settings.lines.brush.empty() && io::formatOf<io::LinesFormat>(output) != io::LinesFormat::LinesJson,
             "--brush", "has no textures");
}

// @param viewsBefore  of other jobs
void check(const Job& job, std::size_t& viewsBefore, FilesApart& files) {
    validate(job.settings);
    const std::vector<View> views = viewsOf(job);
    expectKnownFields(job.metadata);
    for (const std::string& output : job.outputs) {
        expectKnownFields(output);
        expectViewIn(output, views.size());
        if (holdsLines(output)) expectLinesOnly(job, output);
    }
    const std::string model = job.model.string();
    const auto add = [&](const fs::path& file, const FilesApart::Owner& owner) {
        expectFolderFor(file);
        files.addOutput(file, owner);
    };
    for (const View& view : views) {
        const std::string who = fmt::format("view {} of {}", view.name, model);
        for (const std::string& output : job.outputs)
            for (const fs::path& file : filesOfOutput(job, output, view)) add(file, {viewsBefore, who, "--output"});
        if (!job.metadata.empty() && !hasOneMetadataFile(job))
            add(metadataFileOf(job, view), {viewsBefore, who, "--metadata"});
        ++viewsBefore;
    }
    if (hasOneMetadataFile(job))
        add(metadataFileOf(job, views.front()), {viewsBefore - 1, fmt::format("all views of {}", model), "--metadata"});
}

void addInputs(const Job& job, FilesApart& files) {
    if (!job.scene && !job.bytes) files.addInput(job.model, "the model");
    if (!job.settings.lines.brush.empty()) files.addInput(job.settings.lines.brush, "--brush");
    for (const FunctionSettings& function : job.settings.detector.functions)
        if (!function.file.empty()) files.addInput(function.file, "--function");
    for (const fs::path& input : job.inputs) files.addInput(input, "a file that is read,");
}

}  // namespace

FilesApart checkedFiles(std::span<const Job> jobs) {
    FilesApart files;
    for (const Job& job : jobs) addInputs(job, files);
    std::size_t views = 0;
    for (const Job& job : jobs) check(job, views, files);
    return files;
}

}  // namespace job

void checkJobs(std::span<const Job> jobs) { static_cast<void>(job::checkedFiles(jobs)); }

}  // namespace inkedge
