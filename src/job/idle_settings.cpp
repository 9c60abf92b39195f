#include <inkedge/job.h>
#include <inkedge/setting_table.h>

#include "base/file_extension.h"
#include "io/output_formats.h"
#include "job/file_names.h"

namespace inkedge {

std::vector<std::string> idleSettings(const Job& job) {
    const std::vector<View> views = job::viewsOf(job);
    OutputKinds kinds{.views = views.size()};
    kinds.pictures = job.outputs.empty();
    for (const std::string& output : job.outputs) {
        const std::filesystem::path file = job::filesOfOutput(job, output, views.front()).front();
        const std::string extension = base::lowerCaseExtension(file);
        const auto lines = io::formatOf<io::LinesFormat>(file);
        kinds.vectors = kinds.vectors || (lines && io::holdsAreas(*lines));
        kinds.dxf = kinds.dxf || lines == io::LinesFormat::Dxf;
        kinds.json = kinds.json || lines == io::LinesFormat::LinesJson;
        kinds.exr = kinds.exr || extension == ".exr";
        kinds.pictures = kinds.pictures || (!lines && extension != ".exr");
    }
    return idleSettings(job::withMapsOf(job.outputs, job.settings), kinds);
}

}  // namespace inkedge
