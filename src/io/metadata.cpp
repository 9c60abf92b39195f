#include "io/metadata.h"

#include <glm/matrix.hpp>

#include <inkedge/scene.h>
#include <inkedge/setting_table.h>
#include <inkedge/write.h>

namespace inkedge {
namespace {

using io::Json;

Json vectorJson(const glm::dvec3& vector) { return {vector.x, vector.y, vector.z}; }

/// A matrix as four rows of four, for column vectors.
Json matrixJson(const glm::dmat4& matrix) {
    Json rows = Json::array();
    for (int row = 0; row < 4; ++row) {
        rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
    }
    return rows;
}

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

// What metadata say of one view.
struct Drawn {
    const Sphere& bounds;
    std::uint64_t triangles;
    const std::vector<std::string>& warnings;
    const Camera& camera;
    Size size;
    const BackendInfo& backend;
    const std::vector<StageTime>& times;
};

std::string metadataOf(const Drawn& drawn, const Settings& settings) {
    const Json json{{"camera", io::cameraJson(drawn.camera, drawn.size)},
                    {"size", {drawn.size.width, drawn.size.height}},
                    {"bounds", io::boundsJson(drawn.bounds)},
                    {"triangles", drawn.triangles},
                    {"settings", io::settingsJson(settings)},
                    {"warnings", drawn.warnings},
                    {"backend", backendJson(drawn.backend)},
                    {"milliseconds", timesJson(drawn.times)}};
    return io::textOf(json, 2) + '\n';
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

// Names inside a model need not be UTF-8: invalid bytes are replaced.
std::string textOf(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace io

std::string metadataJson(const Scene& scene, const Maps& maps, const Settings& settings) {
    return metadataOf({scene.bounds(), scene.triangleCount(), scene.warnings(), maps.camera, maps.picture.size(),
                       maps.backend, maps.times},
                      settings);
}

std::string metadataJson(const Lines& lines, const Settings& settings) {
    return metadataOf({lines.bounds, lines.source.triangles, lines.source.warnings, lines.camera, lines.size,
                       lines.backend, lines.times},
                      settings);
}

}  // namespace inkedge
