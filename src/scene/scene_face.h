#pragma once

#include <compare>
#include <cstdint>

namespace inkedge::scene {

/// A triangle of an instance.
struct SceneFace {
    std::uint32_t instance = 0;  ///< into Scene::instances()
    std::uint32_t triangle = 0;  ///< of its mesh
    friend auto operator<=>(const SceneFace&, const SceneFace&) = default;
};

}  // namespace inkedge::scene
