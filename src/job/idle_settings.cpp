#include <inkedge/job.h>
#include <inkedge/setting_table.h>
#include <inkedge/write.h>

#include "base/file_extension.h"
#include "job/file_names.h"

namespace inkedge {

std::vector<std::string> idleSettings(const Job& job) {
    const std::vector<View> views = job::viewsOf(job);
    OutputKinds kinds{.views = views.size()};
    kinds.pictures = job.outputs.empty();
    for (const std::string& output : job.outputs) {
        const std::filesystem::path file = job::filesOfOutput(job, output, views.front()).front();
        const std::string extension = base::lowerCaseExtension(file);
        const bool lines = holdsLines(file);
        kinds.svg = kinds.svg || (lines && extension == ".svg");
        kinds.json = kinds.json || (lines && extension == ".json");
        kinds.exr = kinds.exr || extension == ".exr";
        kinds.pictures = kinds.pictures || (!lines && extension != ".exr");
    }
    return idleSettings(job::withMapsOf(job.outputs, job.settings), kinds);
}

}  // namespace inkedge
