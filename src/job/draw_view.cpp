#include "job/draw_view.h"

#include <algorithm>
#include <optional>

#include <inkedge/write.h>

#include "base/stage_clock.h"
#include "base/stop.h"
#include "io/output_formats.h"
#include "io/write_map_files.h"
#include "job/file_names.h"
#include "render/needs_context.h"

namespace inkedge::job {
namespace {

struct Drawn {
    std::optional<Maps> maps;
    std::optional<Lines> lines;
};

// What files of lines hold: some have nothing under their lines.
RenderSettings forLines(const std::vector<std::string>& outputs, RenderSettings settings) {
    const auto holdsShade = [](const std::string& output) {
        const auto format = io::formatOf<io::LinesFormat>(output);
        return format && io::holdsAreas(*format);
    };
    if (std::ranges::none_of(outputs, holdsShade)) settings.shade.shade = Shade::None;
    return settings;
}

Drawn draw(const Job& job, const Scene& scene, const Camera& camera, const Settings& settings, Renderer& renderer) {
    const auto linesAmong = std::ranges::count_if(job.outputs, [](const auto& output) { return holdsLines(output); });
    Drawn drawn;
    if (linesAmong > 0) drawn.lines = renderer.lines(scene, camera, forLines(job.outputs, settings));
    if (linesAmong == 0 || static_cast<std::size_t>(linesAmong) < job.outputs.size())
        drawn.maps = renderer.render(scene, camera, withMapsOf(job.outputs, settings));
    return drawn;
}

std::vector<std::filesystem::path> write(const Drawn& drawn, const Job& job, const View& view,
                                         const Settings& settings) {
    std::vector<std::filesystem::path> files;
    for (const std::string& output : job.outputs) {
        auto written = filesOfOutput(job, output, view);
        if (holdsLines(output))
            writeLines(*drawn.lines, settings, written.front());
        else
            io::writeMapFiles(*drawn.maps, mapsIn(output, settings), written);
        for (auto& file : written) files.push_back(std::move(file));
    }
    return files;
}

void writeText(const std::filesystem::path& file, const std::string& text) {
    writeFile(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace

bool needsContext(const Job& job) {
    const auto forPictures = [&] { return render::pictureNeedsContext(withMapsOf(job.outputs, job.settings)); };
    if (job.outputs.empty()) return forPictures();
    return std::ranges::any_of(job.outputs, [&](const std::string& output) {
        return holdsLines(output) ? render::linesNeedContext(forLines(job.outputs, job.settings)) : forPictures();
    });
}

ViewOutcome drawView(const Job& job, const View& view, const FramedView& framed, const Scene& scene, Renderer& renderer,
                     const std::vector<StageTime>& before, const std::function<void(const Maps&)>& reportDrawn,
                     bool metadata) {
    Settings settings = job.settings;
    settings.camera = view.camera;
    settings.picture = framed.picture;
    Drawn drawn = draw(job, scene, framed.camera, settings, renderer);

    const base::Stopwatch watch;
    JobResult result;
    base::stopIfAsked();  // the last time: no view is written by half
    if (drawn.maps) reportDrawn(*drawn.maps);
    const base::StopScope toTheEnd{static_cast<const base::StopScope*>(nullptr)};
    result.files = write(drawn, job, view, settings);
    const double writing = watch.milliseconds();

    result.times = before;
    if (drawn.lines) result.times.insert(result.times.end(), drawn.lines->times.begin(), drawn.lines->times.end());
    if (drawn.maps) result.times.insert(result.times.end(), drawn.maps->times.begin(), drawn.maps->times.end());
    result.times.push_back({"write", writing});
    result.backend = drawn.maps ? drawn.maps->backend : drawn.lines->backend;

    const bool startsWithLines = !job.outputs.empty() && holdsLines(job.outputs.front());
    (startsWithLines ? drawn.lines->times : drawn.maps->times) = result.times;
    const ViewFiles named{job.model.string(), view.name, result.files};
    io::Json json = startsWithLines ? io::viewMetadata(*drawn.lines, settings, named)
                                    : io::viewMetadata(*drawn.maps, settings, named);
    const bool ownFile = !job.metadata.empty() && !hasOneMetadataFile(job);
    if (metadata || ownFile) result.metadata = io::metadataText(io::modelMetadata(scene, settings, named.model), json);
    if (ownFile) writeText(metadataFileOf(job, view), result.metadata);
    return {std::move(result), std::move(json)};
}

void writeMetadataOfViews(const Job& job, const Scene& scene, std::vector<io::Json> views) {
    std::erase_if(views, [](const io::Json& view) { return view.is_null(); });
    if (views.empty()) return;
    writeText(metadataFileOf(job, viewsOf(job).front()),
              io::metadataText(io::modelMetadata(scene, job.settings, job.model.string()), std::move(views)));
}

}  // namespace inkedge::job
