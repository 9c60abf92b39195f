#pragma once

#include <cstdint>
#include <span>

#include <inkedge/scene.h>
#include <inkedge/scene_names.h>

namespace inkedge::scene {

/// The names of some instances.
/// @param ids  from 1, rising
[[nodiscard]] SceneNames namesOf(const Scene&, std::span<const std::uint32_t> ids);

}  // namespace inkedge::scene
