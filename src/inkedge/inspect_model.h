#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include <inkedge/bounds.h>
#include <inkedge/export.h>
#include <inkedge/scene.h>
#include <inkedge/scene_names.h>
#include <inkedge/settings.h>

namespace inkedge {

struct MeshContents {
    std::string name;             ///< may be empty
    std::uint64_t triangles = 0;  ///< of one instance
    std::uint64_t lines = 0;      ///< straight pieces, of one instance
    std::uint64_t vertices = 0;
    std::uint64_t instances = 0;
};

/// What a model's file holds, as it would be drawn.
struct ModelContents {
    SceneSource source;
    std::vector<MeshContents> meshes;
    std::vector<SceneCamera> cameras;
    std::vector<Material> materials;
    std::vector<std::string> warnings;     ///< as Scene::warnings()
    std::vector<std::string> undrawn;      ///< as Scene::Data::undrawn
    std::vector<NamedInstance> instances;  ///< all that are drawn
    std::uint64_t triangles = 0;           ///< of all instances; 0 is no error
    std::uint64_t lines = 0;               ///< straight pieces, of all instances
    glm::dvec3 up{0.0};                    ///< as Scene::up()
    Box box;                               ///< of all drawn vertices, in world space; empty where nothing is drawn
};

/// Reads a model and says what it holds, whether or not loadScene() finds something to draw.
/// @throws Error  as loadScene(), but not for want of something to draw
[[nodiscard]] INKEDGE_API ModelContents inspectModel(const std::filesystem::path& file,
                                                     const LoadSettings& settings = {});

/// The same of a model in memory, whose bytes and name are as loadScene() takes them.
[[nodiscard]] INKEDGE_API ModelContents inspectModel(std::span<const std::uint8_t> bytes,
                                                     const std::filesystem::path& name,
                                                     const LoadSettings& settings = {});

}  // namespace inkedge
