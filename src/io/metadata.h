#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <inkedge/bounds.h>
#include <inkedge/camera.h>
#include <inkedge/lines.h>
#include <inkedge/maps.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>
#include <inkedge/write.h>

namespace inkedge::io {

using Json = nlohmann::ordered_json;  ///< keys keep their order

Json cameraJson(const Camera&, Size);
Json boundsJson(const Sphere&);
Json settingsJson(const Settings&);

/// What metadata say of a model, whatever the view.
struct ModelFacts {
    const std::string& model;
    const Sphere& bounds;
    std::uint64_t triangles;
    const std::vector<std::string>& warnings;
};
[[nodiscard]] Json modelMetadata(const ModelFacts&, const SceneNames&, const Settings&);
[[nodiscard]] Json modelMetadata(const Scene&, const Settings&, const std::string& model);

/// And what they say of one view.
[[nodiscard]] Json viewMetadata(const Maps&, const Settings&, const ViewFiles&);
[[nodiscard]] Json viewMetadata(const Lines&, const Settings&, const ViewFiles&);

/// Both as the text of a file: of one view, or of several, which are then the list "views".
[[nodiscard]] std::string metadataText(Json model, const Json& view);
[[nodiscard]] std::string metadataText(Json model, std::vector<Json> views);

/// @param indent  -1: on one line
std::string textOf(const Json&, int indent);

/// UTF-8; what is not becomes U+FFFD.
[[nodiscard]] std::string validText(std::string_view);

}  // namespace inkedge::io
