#include <algorithm>
#include <array>
#include <cstring>
#include <string_view>
#include <variant>

#include <fmt/format.h>

#include <inkedge/setting_table.h>
#include <inkedge/views.h>
#include <inkedge/write.h>

#include "c/handles.h"

namespace inkedge::c {
namespace {

FramedView framed(const inkedge_scene& scene, const inkedge_camera* camera, const Settings& settings) {
    if (camera != nullptr) return {camera->value, settings.picture};
    const View view{.name = {}, .camera = settings.camera};
    return frameViews(scene.value, {&view, 1}, settings).front();
}

// A call of a renderer's that inkedge_renderer_stop() ends.
template <class Draw>
auto draw(inkedge_renderer& renderer, const inkedge_scene& scene, const inkedge_camera* camera,
          const inkedge_settings* settings, Draw function) {
    std::stop_source stop;
    {
        const std::scoped_lock lock{renderer.stopping};
        renderer.stop = stop;
    }
    Settings value = valueOf(settings);
    const FramedView view = framed(scene, camera, value);
    value.picture = view.picture;
    return function(view.camera, value, stop.get_token());
}

constexpr std::array types{INKEDGE_UINT8, INKEDGE_UINT16, INKEDGE_UINT32, INKEDGE_FLOAT32};  // in the order of AnyImage

template <class Sample>
inkedge_buffer bufferOf(const Image<Sample>& image, inkedge_type type) {
    const auto pixel = static_cast<ptrdiff_t>(sizeof(Sample)) * image.channels();
    return {image.pixels().data(),      type, image.size().width, image.size().height, image.channels(),
            pixel * image.size().width, pixel};
}

inkedge_buffer bufferOf(const Maps& maps, Map map) {
    const AnyImagePointer image = imageOf(maps, map);
    return std::visit([&](const auto* each) { return bufferOf(*each, types[image.index()]); }, image);
}

// The field of a line's first point, to be stepped from.
template <class Field>
const double* numbersOf(const Line& line, Field LinePoint::*field) {
    return reinterpret_cast<const double*>(&(line.points.front().*field));
}

}  // namespace
}  // namespace inkedge::c

using namespace inkedge::c;
using inkedge::Error;

inkedge_status inkedge_renderer_create(const inkedge_settings* settings, inkedge_renderer** renderer) {
    return handOut(renderer, [&] {
        return new inkedge_renderer{
            inkedge::Renderer{valueOf(settings).backend, inkedge::ContextTime::WhenNeeded}, {}, {}};
    });
}

void inkedge_renderer_free(inkedge_renderer* renderer) { delete renderer; }

void inkedge_renderer_stop(inkedge_renderer* renderer) {
    const std::scoped_lock lock{renderer->stopping};
    renderer->stop.request_stop();
}

inkedge_status inkedge_render(inkedge_renderer* renderer, const inkedge_scene* scene, const inkedge_camera* camera,
                              const inkedge_settings* settings, inkedge_maps** maps) {
    return handOut(maps, [&] {
        return draw(
            given(renderer, "renderer"), given(scene, "scene"), camera, settings,
            [&](const inkedge::Camera& from, const inkedge::Settings& value, const std::stop_token& stop) {
                return new inkedge_maps{renderer->value.render(scene->value, from, value, stop), value.maps, {}};
            });
    });
}

void inkedge_maps_free(inkedge_maps* maps) { delete maps; }

inkedge_status inkedge_maps_get(const inkedge_maps* maps, const char* name, inkedge_buffer* buffer) {
    return guarded([&] {
        const inkedge_maps& of = given(maps, "maps");
        const std::string_view asked = &given(name, "name");
        if (asked == "picture") {
            given(buffer, "buffer") = bufferOf(of.value.picture, INKEDGE_UINT8);
            return;
        }
        const auto found =
            std::ranges::find_if(of.asked, [&](inkedge::Map map) { return inkedge::name(map) == asked; });
        if (found == of.asked.end())
            throw Error{Error::Kind::Usage,
                        fmt::format("expected picture or a map that was asked for, found '{}'", asked)};
        given(buffer, "buffer") = bufferOf(of.value, *found);
    });
}

inkedge_status inkedge_maps_write(const inkedge_maps* maps, const char* file) {
    return guarded([&] {
        const inkedge_maps& of = given(maps, "maps");
        inkedge::writeMaps(of.value, of.asked, &given(file, "file"));
    });
}

inkedge_status inkedge_maps_metadata(inkedge_maps* maps, const inkedge_scene* scene, const inkedge_settings* settings,
                                     const char** json) {
    return guarded([&] {
        inkedge_maps& of = given(maps, "maps");
        of.metadata = inkedge::metadataJson(given(scene, "scene").value, of.value, valueOf(settings));
        given(json, "json") = of.metadata.c_str();
    });
}

inkedge_status inkedge_find_lines(inkedge_renderer* renderer, const inkedge_scene* scene, const inkedge_camera* camera,
                                  const inkedge_settings* settings, inkedge_lines** lines) {
    return handOut(lines, [&] {
        return draw(given(renderer, "renderer"), given(scene, "scene"), camera, settings,
                    [&](const inkedge::Camera& from, const inkedge::Settings& value, const std::stop_token& stop) {
                        return new inkedge_lines{renderer->value.lines(scene->value, from, value, stop)};
                    });
    });
}

void inkedge_lines_free(inkedge_lines* lines) { delete lines; }

size_t inkedge_lines_count(const inkedge_lines* lines) { return lines->value.lines.size(); }

inkedge_status inkedge_lines_get(const inkedge_lines* lines, size_t index, inkedge_line* line) {
    return guarded([&] {
        const std::vector<inkedge::Line>& all = given(lines, "lines").value.lines;
        if (index >= all.size())
            throw Error{Error::Kind::Usage, fmt::format("expected a line under {}, found {}", all.size(), index)};
        const inkedge::Line& of = all[index];
        given(line, "line") = {inkedge::name(of.type).data(),
                               of.visible ? 1 : 0,
                               of.closed ? 1 : 0,
                               of.id,
                               of.object,
                               of.patch,
                               of.width,
                               of.points.size(),
                               sizeof(inkedge::LinePoint),
                               numbersOf(of, &inkedge::LinePoint::pixel),
                               numbersOf(of, &inkedge::LinePoint::position),
                               numbersOf(of, &inkedge::LinePoint::strength)};
    });
}

inkedge_status inkedge_lines_write(const inkedge_lines* lines, const inkedge_settings* settings, const char* file) {
    return guarded([&] { inkedge::writeLines(given(lines, "lines").value, valueOf(settings), &given(file, "file")); });
}
