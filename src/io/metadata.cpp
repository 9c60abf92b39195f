#include "io/metadata.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <glm/matrix.hpp>

#include <inkedge/scene.h>
#include <inkedge/setting_table.h>
#include <inkedge/write.h>

#include "io/map_pictures.h"
#include "io/names_json.h"

namespace inkedge {
namespace {

using io::Json;

Json vectorJson(const glm::dvec3& vector) { return {vector.x, vector.y, vector.z}; }

Json backendJson(const BackendInfo& info) {
    if (info.backend.empty()) return {};  // null: no backend was used
    return {{"backend", info.backend},   {"platform", info.platform}, {"vendor", info.vendor},
            {"renderer", info.renderer}, {"version", info.version},   {"software", info.software}};
}

Json timesJson(const std::vector<StageTime>& times) {
    Json json = Json::object();
    for (const auto& [stage, milliseconds] : times) json[stage] = json.value(stage, 0.0) + milliseconds;
    return json;
}

// Camera matrices as OpenCV has them: x right, y down, z into the scene; (0, 0) the middle of the first pixel.
void addOpenCv(Json& json, const Camera& camera, Size size) {
    json["world_to_camera"] = io::matrixJson(camera.worldToCamera());
    Json rows = Json::array();
    const glm::dmat3 k = camera.intrinsics(size);
    for (int row = 0; row < 3; ++row) rows.push_back({k[0][row], k[1][row], k[2][row]});
    json["K"] = std::move(rows);
}

// What was drawn of one view.
struct Drawn {
    const Camera& camera;
    Size size;
    std::optional<double> dpi;
    const BackendInfo& backend;
    const std::vector<StageTime>& times;
};

Json viewJson(const Drawn& drawn, const Settings& settings, const ViewFiles& files) {
    Json camera = io::cameraJson(drawn.camera, drawn.size);
    addOpenCv(camera, drawn.camera, drawn.size);
    Json json{{"view", files.view.empty() ? Json{} : Json(files.view)}, {"files", Json::array()}};
    for (const std::filesystem::path& file : files.files) json["files"].push_back(file.string());
    json["camera"] = std::move(camera);
    json["size"] = {drawn.size.width, drawn.size.height};
    json["dpi"] = drawn.dpi ? Json(*drawn.dpi) : Json{};
    if (std::ranges::find(settings.maps, Map::Depth) != settings.maps.end())
        json["depth_png"] = {{"offset", drawn.camera.near}, {"scale", io::depthScale(drawn.camera)}};
    json["backend"] = backendJson(drawn.backend);
    json["milliseconds"] = timesJson(drawn.times);
    return json;
}

}  // namespace

namespace io {

Json cameraJson(const Camera& camera, Size size) {
    Json json{{"view", matrixJson(camera.view)},
              {"projection", matrixJson(camera.projection(size))},
              {"near", camera.near},
              {"far", camera.far}};
    if (camera.orthographic()) {
        json["orthographic_height"] = camera.orthographicHeight;
    } else {
        json["view_angle"] = camera.viewAngle;
    }
    if (camera.pixelAspect != 1.0) json["pixel_aspect"] = camera.pixelAspect;
    if (camera.axis != glm::dvec2{0.0}) json["axis"] = {camera.axis.x, camera.axis.y};
    json["eye"] = vectorJson(glm::dvec3{glm::inverse(camera.view)[3]});
    return json;
}

Json settingsJson(const Settings& settings) {
    Json json = Json::object();
    for (const SettingDescription& setting : settingTable()) {
        const std::string text = setting.get(settings);
        json[std::string{setting.name}] = text.empty() ? Json{} : Json(text);
    }
    return json;
}

Json boundsJson(const Sphere& bounds) { return {{"centre", vectorJson(bounds.centre)}, {"radius", bounds.radius}}; }

Json modelMetadata(const ModelFacts& facts, const SceneNames& names, const Settings& settings) {
    Json json{{"model", facts.model.empty() ? Json{} : Json(facts.model)},
              {"bounds", boundsJson(facts.bounds)},
              {"triangles", facts.triangles}};
    json["instances"] = instancesJson(names);
    json["materials"] = materialsJson(names);
    json["settings"] = settingsJson(settings);
    json["warnings"] = facts.warnings;
    return json;
}

Json modelMetadata(const Scene& scene, const Settings& settings, const std::string& model) {
    Json json =
        modelMetadata({model, scene.bounds(), scene.triangleCount(), scene.warnings()}, namesOf(scene), settings);
    json["up"] = vectorJson(scene.up());
    return json;
}

Json viewMetadata(const Maps& maps, const Settings& settings, const ViewFiles& files) {
    return viewJson({maps.camera, maps.picture.size(), maps.dpi, maps.backend, maps.times}, settings, files);
}

Json viewMetadata(const Lines& lines, const Settings& settings, const ViewFiles& files) {
    return viewJson({lines.camera, lines.size, settings.picture.dpi, lines.backend, lines.times}, settings, files);
}

std::string metadataText(Json model, const Json& view) {
    for (const auto& [key, value] : view.items()) model[key] = value;
    return textOf(model, 2) + '\n';
}

std::string metadataText(Json model, std::vector<Json> views) {
    model["views"] = std::move(views);
    return textOf(model, 2) + '\n';
}

// Names inside a model need not be UTF-8: invalid bytes are replaced.
std::string textOf(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

std::string validText(std::string_view text) { return Json::parse(textOf(std::string{text}, -1)).get<std::string>(); }

}  // namespace io

std::string metadataJson(const Scene& scene, const Maps& maps, const Settings& settings, const ViewFiles& files) {
    return io::metadataText(io::modelMetadata(scene, settings, files.model), io::viewMetadata(maps, settings, files));
}

std::string metadataJson(const Lines& lines, const Settings& settings, const ViewFiles& files) {
    const Json model = io::modelMetadata({files.model, lines.bounds, lines.source.triangles, lines.source.warnings},
                                         lines.names, settings);
    return io::metadataText(model, io::viewMetadata(lines, settings, files));
}

}  // namespace inkedge
