#include <filesystem>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/scene.h>

#include "scene/load_gltf.h"

namespace inkedge {

Scene loadScene(const std::filesystem::path& file, const LoadSettings& settings) {
    Scene::Data data = loadGltf(file);
    try {
        return Scene{std::move(data), settings};
    } catch (const Error& error) {
        throw Error{error.kind(), fmt::format("{}: {}", file.string(), error.what())};
    }
}

}  // namespace inkedge
