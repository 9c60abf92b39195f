#include "job/draw_view.h"

#include <algorithm>
#include <optional>

#include <inkedge/load_scene.h>
#include <inkedge/write.h>

#include "base/stage_clock.h"
#include "base/staged_files.h"
#include "base/stop.h"
#include "io/output_formats.h"
#include "job/file_names.h"
#include "job/output_kinds.h"
#include "render/needs_context.h"
#include "settings/idle.h"

namespace inkedge::job {
namespace {

// What files of lines hold: some have nothing under their lines.
RenderSettings forLines(const std::vector<std::string>& outputs, RenderSettings settings) {
    const auto holdsShade = [](const std::string& output) {
        const auto format = io::formatOf<io::LinesFormat>(output);
        return format && io::holdsAreas(*format);
    };
    if (std::ranges::none_of(outputs, holdsShade)) settings.shade.shade = Shade::None;
    return settings;
}

bool startsWithLines(const Job& job) { return !job.outputs.empty() && holdsLines(job.outputs.front()); }

void writeText(const std::filesystem::path& file, const std::string& text) {
    writeFile(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

}  // namespace

Scene sceneOf(const Job& job, std::span<const View> views, Besides besides) {
    LoadSettings load = loadSettings(job.settings, views);
    load.completeNormals = besides == Besides::LinesOfTheMesh ||
                           settings::readsVertexNormals(withMapsOf(job.outputs, job.settings), kindsOf(job, views));
    return job.bytes ? loadScene(*job.bytes, job.model, load) : loadScene(job.model, load);
}

bool needsContext(const Job& job) {
    const auto forPictures = [&] { return render::pictureNeedsContext(withMapsOf(job.outputs, job.settings)); };
    if (job.outputs.empty()) return forPictures();
    return std::ranges::any_of(job.outputs, [&](const std::string& output) {
        return holdsLines(output) ? render::linesNeedContext(forLines(job.outputs, job.settings)) : forPictures();
    });
}

bool needsRays(const Job& job) {
    return std::ranges::any_of(job.outputs, [&](const std::string& output) {
        return holdsLines(output) ? job.settings.lines.from != LinesFrom::Image
                                  : render::pictureNeedsRays(withMapsOf(job.outputs, job.settings));
    });
}

DrawnView draw(const Job& job, const View& view, const FramedView& framed, const Scene& scene, Renderer& renderer) {
    DrawnView drawn{job.settings, {}, {}};
    drawn.settings.camera = view.camera;
    drawn.settings.picture = framed.picture;
    const auto linesAmong = std::ranges::count_if(job.outputs, [](const auto& output) { return holdsLines(output); });
    if (linesAmong > 0) drawn.lines = renderer.lines(scene, framed.camera, forLines(job.outputs, drawn.settings));
    if (linesAmong == 0 || static_cast<std::size_t>(linesAmong) < job.outputs.size())
        drawn.maps = renderer.render(scene, framed.camera, withMapsOf(job.outputs, drawn.settings));
    return drawn;
}

std::vector<std::filesystem::path> encode(const DrawnView& drawn, const Job& job, const View& view,
                                          const io::TakeFile& take) {
    std::vector<std::filesystem::path> files;
    for (const std::string& output : job.outputs) {
        auto named = filesOfOutput(job, output, view);
        if (holdsLines(output))
            take(named.front(), io::encodeLines(*drawn.lines, drawn.settings, named.front()));
        else
            io::encodeMaps(*drawn.maps, mapsIn(output, drawn.settings), named, take);
        for (auto& file : named) files.push_back(std::move(file));
    }
    return files;
}

io::Json metadataOf(const DrawnView& drawn, const Job& job, const ViewFiles& named) {
    return startsWithLines(job) ? io::viewMetadata(*drawn.lines, drawn.settings, named)
                                : io::viewMetadata(*drawn.maps, drawn.settings, named);
}

ViewOutcome drawView(const Job& job, const View& view, const FramedView& framed, const Scene& scene, Renderer& renderer,
                     const std::vector<StageTime>& before, const std::function<void(const Maps&)>& reportDrawn,
                     bool metadata) {
    DrawnView drawn = draw(job, view, framed, scene, renderer);

    const base::Stopwatch watch;
    JobResult result;
    base::stopIfAsked();  // the last time: no view is written by half
    if (drawn.maps) reportDrawn(*drawn.maps);
    const base::StopScope toTheEnd{static_cast<const base::StopScope*>(nullptr)};
    base::StagedFiles staged;
    result.files = encode(drawn, job, view, [&](const auto& file, auto bytes) { staged.add(file, bytes); });
    staged.commit();
    const double writing = watch.milliseconds();

    result.times = before;
    if (drawn.lines) result.times.insert(result.times.end(), drawn.lines->times.begin(), drawn.lines->times.end());
    if (drawn.maps) result.times.insert(result.times.end(), drawn.maps->times.begin(), drawn.maps->times.end());
    result.times.push_back({"write", writing});
    result.backend = drawn.maps ? drawn.maps->backend : drawn.lines->backend;

    (startsWithLines(job) ? drawn.lines->times : drawn.maps->times) = result.times;
    const ViewFiles named{job.model.string(), view.name, result.files};
    io::Json json = metadataOf(drawn, job, named);
    const bool ownFile = !job.metadata.empty() && !hasOneMetadataFile(job);
    if (metadata || ownFile)
        result.metadata = io::metadataText(io::modelMetadata(scene, drawn.settings, named.model), json);
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
