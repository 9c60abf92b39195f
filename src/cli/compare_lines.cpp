#include "cli/compare_lines.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <inkedge/load_scene.h>
#include <inkedge/read_lines.h>
#include <inkedge/renderer.h>
#include <inkedge/views.h>

#include "base/file_extension.h"

namespace inkedge::cli {
namespace {

bool isModel(const std::string& file) {
    const std::string extension = base::lowerCaseExtension(file);
    return std::ranges::any_of(readableFormats(), [&](const ModelFormat& format) {
        return std::ranges::find(format.extensions, extension) != format.extensions.end();
    });
}

struct Viewpoint {
    Camera camera;
    PictureSettings picture;
};

Viewpoint viewpointOf(const Lines& lines, const Settings& settings) {
    Viewpoint viewpoint{lines.camera, settings.picture};
    viewpoint.picture.size = lines.size;
    return viewpoint;
}

Viewpoint viewpointOf(const Scene& scene, const Settings& settings) {
    const View view{"", settings.camera};
    FramedView framed = std::move(frameViews(scene, {&view, 1}, settings).front());
    return {framed.camera, framed.picture};
}

// Draws models, all by the first viewpoint that it is given.
class ModelLines {
public:
    explicit ModelLines(const Settings& settings) : settings_{settings} {
        // Hidden lines are found in any case: what was hidden and is seen now is known to have been there.
        if (settings_.lines.from != LinesFrom::Image) settings_.lines.hidden = HiddenLines::Solid;
    }

    void standAt(const Lines& lines) { viewpoint_ = viewpointOf(lines, settings_); }

    ComparedLines of(const std::string& model, std::vector<std::string>& warnings) {
        const Scene scene = loadScene(model, loadSettings(settings_));
        for (const std::string& warning : scene.warnings()) warnings.push_back(fmt::format("{}: {}", model, warning));
        if (!viewpoint_) viewpoint_ = viewpointOf(scene, settings_);
        Settings settings = settings_;
        settings.picture = viewpoint_->picture;
        Camera camera = viewpoint_->camera;
        camera.near = camera.far = 0.0;  // fitted to each model
        return comparedLines(renderer_.lines(scene, camera, settings), settings);
    }

private:
    Settings settings_;
    Renderer renderer_{settings_.backend, ContextTime::WhenNeeded};
    std::optional<Viewpoint> viewpoint_;
};

bool hasHidden(const ComparedLines& lines) {
    return std::ranges::any_of(lines.lines, [](const ComparedLine& line) { return !line.visible; });
}

}  // namespace

bool actsOnComparedLines(const SettingDescription& row) {
    using namespace std::string_view_literals;
    constexpr std::array drawing{"stroke-width"sv, "stroke-taper"sv, "brush"sv,
                                 "fit-curves"sv,   "path-order"sv,   "simplify"sv};
    constexpr std::array picture{"size"sv,       "crop"sv,          "scale"sv,     "dpi"sv,
                                 "line-width"sv, "supersampling"sv, "line-style"sv};
    if (row.group == "lines") return std::ranges::find(drawing, row.name) == drawing.end();
    if (row.group == "picture") return std::ranges::find(picture, row.name) != picture.end();
    return row.group == "camera" || row.group == "model" || row.group == "limits" || row.group == "backend";
}

std::vector<std::string> idleWithoutModels(const SettingsSources& sources) {
    std::vector<std::string> warnings;
    for (const std::string_view name : sources.flagsGiven())
        warnings.push_back(fmt::format("--{} does nothing: it is for models", name));
    return warnings;
}

ComparedInputs readComparedInputs(const std::string& a, const std::string& b, const SettingsSources& sources) {
    const Settings settings = sources.resolve();
    ComparedInputs inputs;
    const std::array files{&a, &b};
    const std::array sides{&inputs.a, &inputs.b};
    ModelLines models{settings};
    bool anyModel = false;
    for (std::size_t i = 0; i < files.size(); ++i) {
        if (isModel(*files[i])) {
            anyModel = true;
            continue;
        }
        *sides[i] = readComparedLines(*files[i]);
        if (base::lowerCaseExtension(*files[i]) == ".json") models.standAt(readLines(*files[i]));
    }
    if (!anyModel) {
        inputs.warnings = idleWithoutModels(sources);
        return inputs;
    }
    const bool counts = settings.lines.hidden != HiddenLines::None || hasHidden(inputs.a) || hasHidden(inputs.b);
    if (!counts) inputs.hidden = HiddenChanges::Ignore;
    for (std::size_t i = 0; i < files.size(); ++i)
        if (isModel(*files[i])) *sides[i] = models.of(*files[i], inputs.warnings);
    return inputs;
}

}  // namespace inkedge::cli
