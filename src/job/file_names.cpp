#include "job/file_names.h"

#include <string_view>

#include <inkedge/write.h>

namespace inkedge {
namespace job {
namespace {

std::string expandField(std::string text, std::string_view field, const std::string& value) {
    for (std::size_t at = 0; (at = text.find(field, at)) != std::string::npos; at += value.size()) {
        text.replace(at, field.size(), value);
    }
    return text;
}

std::string expandTemplate(const std::string& text, const Job& job, const View& view) {
    return expandField(expandField(text, "{model}", job.model.stem().string()), "{view}", view.name);
}

}  // namespace

std::vector<View> viewsOf(const Job& job) {
    return job.views.empty() ? std::vector<View>{{"0", job.settings.camera}} : job.views;
}

std::filesystem::path outputOf(const Job& job, const std::string& output, const View& view) {
    const std::string file = expandTemplate(output, job, view);
    return holdsLines(file) ? expandField(file, "{map}", "outline") : file;
}

std::filesystem::path metadataFileOf(const Job& job, const View& view) {
    return expandTemplate(job.metadata, job, view);
}

}  // namespace job

std::vector<std::filesystem::path> filesOf(const Job& job, const View& view) {
    std::vector<std::filesystem::path> files;
    for (const std::string& output : job.outputs) {
        const std::filesystem::path file = job::outputOf(job, output, view);
        if (holdsLines(file)) {
            files.push_back(file);
        } else {
            for (auto& each : outputFiles(file, job.settings.maps)) files.push_back(std::move(each));
        }
    }
    if (!job.metadata.empty()) files.push_back(job::metadataFileOf(job, view));
    return files;
}

}  // namespace inkedge
