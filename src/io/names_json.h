#pragma once

#include <inkedge/scene_names.h>

#include "io/json_object.h"
#include "io/metadata.h"

namespace inkedge::io {

/// Four rows of four, for column vectors.
[[nodiscard]] Json matrixJson(const glm::dmat4&);
/// @throws Error  (Kind::Input) if it is none
[[nodiscard]] glm::dmat4 readMatrix(const JsonObject&, std::string_view key);

[[nodiscard]] Json instancesJson(const SceneNames&);
[[nodiscard]] Json materialsJson(const SceneNames&);

/// Both of a JSON object that has them.
/// @throws Error  (Kind::Input) if a value is missing, of another type or out of range, or ids are not rising
[[nodiscard]] SceneNames readNames(const JsonObject&);

}  // namespace inkedge::io
