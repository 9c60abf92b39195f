#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include <inkedge/bounds.h>
#include <inkedge/camera.h>
#include <inkedge/settings.h>

namespace inkedge::io {

using Json = nlohmann::ordered_json;  ///< keys keep their order

Json cameraJson(const Camera&, Size);
Json boundsJson(const Sphere&);
Json settingsJson(const Settings&);

/// @param indent  -1: on one line
std::string textOf(const Json&, int indent);

}  // namespace inkedge::io
