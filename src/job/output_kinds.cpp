#include "job/output_kinds.h"

#include "base/file_extension.h"
#include "io/output_formats.h"
#include "job/file_names.h"

namespace inkedge::job {

OutputKinds kindsOf(const Job& job, std::span<const View> views) {
    OutputKinds kinds{.views = views.size()};
    kinds.pictures = job.outputs.empty();
    for (const std::string& output : job.outputs) {
        const std::filesystem::path file = filesOfOutput(job, output, views.front()).front();
        const std::string extension = base::lowerCaseExtension(file);
        const auto lines = io::formatOf<io::LinesFormat>(file);
        kinds.vectors = kinds.vectors || (lines && io::holdsAreas(*lines));
        kinds.dxf = kinds.dxf || lines == io::LinesFormat::Dxf;
        kinds.json = kinds.json || lines == io::LinesFormat::LinesJson;
        kinds.exr = kinds.exr || extension == ".exr";
        kinds.pictures = kinds.pictures || (!lines && extension != ".exr");
    }
    return kinds;
}

}  // namespace inkedge::job
