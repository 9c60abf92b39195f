#include "tune/studio.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <inkedge/setting_table.h>
#include <inkedge/views.h>

#include "base/stop.h"
#include "job/file_names.h"
#include "tune/half_size.h"
#include "tune/layers.h"

namespace inkedge::tune {
namespace {

constexpr const char* anyPicture = "picture.png";

std::vector<std::uint8_t> bytesOf(const job::DrawnView& drawn, const Job& job) {
    std::vector<std::uint8_t> bytes;
    (void)job::encode(drawn, job, job::viewsOf(job).front(),
                      [&](const auto&, auto encoded) { bytes.assign(encoded.begin(), encoded.end()); });
    return bytes;
}

constexpr int reach = 4;  // pixels: a line is hit where its ink is, not only in its middle

// The types on the square of pixels around one that are so far away.
LineTypes typesAt(const Image<std::uint16_t>& types, int x, int y, int away) {
    LineTypes found;
    for (int dy = -away; dy <= away; ++dy) {
        const int step = std::abs(dy) == away ? 1 : 2 * away;
        for (int dx = -away; dx <= away; dx += std::max(step, 1)) {
            const int atX = x + dx;
            const int atY = y + dy;
            if (atX >= 0 && atY >= 0 && atX < types.size().width && atY < types.size().height)
                found |= LineTypes::fromBits(types(atX, atY));
        }
    }
    return found;
}

LineTypes nearestTypes(const Image<std::uint16_t>& types, int x, int y) {
    LineTypes found;
    for (int away = 0; away <= reach && found.empty(); ++away) found = typesAt(types, x, y, away);
    return found;
}

}  // namespace

Scene Studio::scene(const Settings& settings) {
    return scenes_.of({.model = model_, .settings = settings}, Fineness::AsForPicture);
}

Studio::Drawn Studio::drawJob(const Job& job, Fineness fineness) {
    validate(job.settings);
    Scene scene = scenes_.of(job, fineness);
    const auto lock = base::lockUnlessStopped(drawing_);
    const std::vector<View> views = job::viewsOf(job);
    const FramedView framed = frameViews(scene, views, job.settings).front();
    try {
        return {job::draw(job, views.front(), framed, scene, renderer_.of(job.settings.backend)), scene};
    } catch (const Error& error) {
        if (error.kind() == Error::Kind::Runtime) renderer_.giveUp();  // its context may be lost
        throw;
    }
}

StudioPicture Studio::draw(const Settings& settings, Detail detail, const std::stop_token& stop) {
    const base::StopScope stops{[&] { return stop.stop_requested(); }};
    const bool half = detail == Detail::Half;
    Job job{.model = model_, .settings = half ? halfSize(settings) : settings, .outputs = {anyPicture}};
    const auto [drawn, scene] = drawJob(job, half ? Fineness::Any : Fineness::AsForPicture);
    const Maps& maps = *drawn.maps;
    StudioPicture picture{{}, {}, maps.camera, maps.picture.size(), scene, maps.warnings};
    for (const Map map : settings.maps) {
        base::stopIfAsked();
        picture.layers.emplace_back(map, layerPicture(maps, map));
    }
    job.settings.maps.clear();  // they are no files here
    picture.png = bytesOf(drawn, job);
    return picture;
}

std::vector<std::uint8_t> Studio::file(const Settings& settings, const std::string& output,
                                       const std::stop_token& stop) {
    const base::StopScope stops{[&] { return stop.stop_requested(); }};
    Job job{.model = model_, .settings = settings, .outputs = {output}};
    job.settings.maps.clear();
    return bytesOf(drawJob(job, Fineness::AsForPicture).view, job);
}

std::shared_ptr<const Maps> Studio::hoverMaps(const Settings& settings) {
    const std::string key = configText(settings);
    {
        const auto lock = base::lockUnlessStopped(drawing_);
        if (hovered_ && hoveredKey_ == key) return hovered_;
    }
    Job job{.model = model_, .settings = settings, .outputs = {anyPicture}};
    job.settings.maps = {Map::Types, Map::Ids};
    job.settings.picture.supersampling = 1;
    auto maps = std::make_shared<const Maps>(std::move(*drawJob(job, Fineness::AsForPicture).view.maps));
    const auto lock = base::lockUnlessStopped(drawing_);
    hovered_ = maps;
    hoveredKey_ = key;
    return maps;
}

Hovered Studio::hover(const Settings& settings, int x, int y, const std::stop_token& stop) {
    const base::StopScope stops{[&] { return stop.stop_requested(); }};
    const std::shared_ptr<const Maps> drawn = hoverMaps(settings);
    const Maps& maps = *drawn;
    Hovered found;
    if (x < 0 || y < 0 || x >= maps.ids.size().width || y >= maps.ids.size().height) return found;
    for (const LineType type : nearestTypes(maps.types, x, y)) found.types.emplace_back(name(type));
    found.patch = maps.ids(x, y, 0);
    const std::uint32_t object = maps.ids(x, y, 2);
    const auto named = std::ranges::find(maps.names.instances, object, &NamedInstance::id);
    if (named != maps.names.instances.end()) found.object = named->node;
    return found;
}

}  // namespace inkedge::tune
