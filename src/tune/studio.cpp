#include "tune/studio.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <inkedge/setting_table.h>
#include <inkedge/views.h>

#include "base/stop.h"
#include "job/draw_view.h"
#include "job/file_names.h"

namespace inkedge::tune {
namespace {

constexpr std::string_view anyPicture = "picture.png";

Settings forDetail(Settings settings, Detail detail) {
    if (detail == Detail::Full) return settings;
    Size& size = settings.picture.size;
    size = {std::max(size.width / 2, 1), std::max(size.height / 2, 1)};
    settings.picture.supersampling = 1;
    return settings;
}

// The settings that decide how a model is loaded, and maybe others. Those of the camera decide how fine CAD files and
// implicit surfaces become, which may wait until nothing moves.
std::string keyOf(const Settings& settings, Detail detail) {
    std::string key;
    for (const SettingDescription& row : settingTable()) {
        if (row.group == "backend" || row.name == "background" || row.name == "line-color" || row.name == "line-style")
            continue;
        if (detail == Detail::Half && (row.group == "camera" || row.name == "size" || row.name == "supersampling"))
            continue;
        key += row.get(settings) + '\n';
    }
    return key;
}

// Whether its triangles stand for smooth surfaces, as finely as the picture needs.
bool isCurved(const Scene& scene) {
    constexpr std::array<std::string_view, 4> formats{"STEP", "IGES", "BREP", "implicit surface"};
    return std::ranges::find(formats, scene.source().format) != formats.end();
}

}  // namespace

const Scene& Studio::sceneOf(const Job& job, Detail detail) {
    const std::string moving = keyOf(job.settings, Detail::Half);
    const bool refines = scene_ && isCurved(*scene_);
    const std::string key = moving + (refines ? keyOf(job.settings, Detail::Full) : "");
    const bool fits = scene_ && (key == sceneKey_ || (detail == Detail::Half && sceneKey_.starts_with(moving)));
    if (!fits) {
        scene_.reset();
        hovered_.reset();
        scene_ = job::sceneOf(job, job::viewsOf(job));
        sceneKey_ = moving + (isCurved(*scene_) ? keyOf(job.settings, Detail::Full) : "");
    }
    return *scene_;
}

Scene Studio::scene(const Settings& settings) {
    const std::scoped_lock lock{drawing_};
    return sceneOf({.model = model_, .settings = settings}, Detail::Full);
}

StudioFile Studio::draw(Settings settings, const std::string& output, std::optional<Map> map, Detail detail,
                        const std::stop_token& stop) {
    const base::StopScope stops{[&] { return stop.stop_requested(); }};
    settings = forDetail(std::move(settings), detail);
    settings.maps.clear();
    if (map) settings.maps = {*map};
    const Job job{.model = model_, .settings = settings, .outputs = {output}};
    validate(settings);
    const auto lock = base::lockUnlessStopped(drawing_);
    const Scene& scene = sceneOf(job, detail);
    const std::vector<View> views = job::viewsOf(job);
    const FramedView framed = frameViews(scene, views, settings).front();
    const job::DrawnView drawn = job::draw(job, views.front(), framed, scene, renderer_.of(settings.backend));
    StudioFile file{{}, framed.camera, framed.picture.size};
    (void)job::encode(drawn, job, views.front(), [&](const auto&, auto bytes) {
        file.bytes.assign(bytes.begin(), bytes.end());  // of several, the map comes last
    });
    return file;
}

Hovered Studio::hover(const Settings& given, int x, int y) {
    const std::scoped_lock lock{drawing_};
    Settings settings = given;
    settings.maps = {Map::Types, Map::Ids};
    settings.picture.supersampling = 1;
    const Job job{.model = model_, .settings = settings, .outputs = {std::string{anyPicture}}};
    const Scene& scene = sceneOf(job, Detail::Half);
    if (const std::string key = configText(settings); !hovered_ || key != hoveredKey_) {
        const FramedView framed = frameViews(scene, job::viewsOf(job), settings).front();
        settings.picture = framed.picture;
        hovered_ = renderer_.of(settings.backend).render(scene, framed.camera, settings);
        hoveredKey_ = key;
    }
    Hovered found;
    const Maps& maps = *hovered_;
    if (x < 0 || y < 0 || x >= maps.ids.size().width || y >= maps.ids.size().height) return found;
    // A line is a few pixels wide; its types stand on those in its middle.
    LineTypes types;
    for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
            const int atX = std::clamp(x + dx, 0, maps.types.size().width - 1);
            const int atY = std::clamp(y + dy, 0, maps.types.size().height - 1);
            types |= LineTypes::fromBits(maps.types(atX, atY));
        }
    }
    for (const LineType type : types) found.types.emplace_back(name(type));
    found.patch = maps.ids(x, y, 0);
    const std::uint32_t object = maps.ids(x, y, 2);
    const auto named = std::ranges::find(maps.names.instances, object, &NamedInstance::id);
    if (named != maps.names.instances.end()) found.object = named->node;
    return found;
}

}  // namespace inkedge::tune
