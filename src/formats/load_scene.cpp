#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>
#include <inkedge/scene.h>
#include <inkedge/setting_table.h>

#include "base/message.h"
#include "base/read_file.h"
#include "formats/gltf/load_gltf.h"
#include "formats/polygons/load_polygons.h"

namespace inkedge {
namespace {

namespace fs = std::filesystem;
using load::PolygonFormat;

std::string lowerCaseExtension(const fs::path& file) {
    std::string extension = file.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; });
    return extension;
}

std::optional<PolygonFormat> polygonFormat(std::string_view extension) {
    using enum PolygonFormat;
    for (const auto& [format, itsExtension] : {std::pair{Obj, ".obj"}, {Stl, ".stl"}, {Ply, ".ply"}})
        if (extension == itsExtension) return format;
    return {};
}

// By extension, but for binary glTF, which says what it is.
Scene::Data loadByFormat(const fs::path& file, const LoadSettings& settings) {
    const std::string extension = lowerCaseExtension(file);
    if (extension == ".glb" || extension == ".gltf") return loadGltf(file, settings);
    const load::Bytes start = load::within(load::printable(file.string()), [&] { return load::readStart(file, 512); });
    if (load::textOf(start).starts_with("glTF")) return loadGltf(file, settings);
    if (const std::optional<PolygonFormat> format = polygonFormat(extension))
        return loadPolygons(file, *format, settings.limits,
                            settings.textureCoordinates ? load::Coordinates::Read : load::Coordinates::Skip);
    load::refuse(fmt::format("{}: expected a model by its extension, .glb, .gltf, .obj, .stl or .ply, found {} with {}",
                             load::printable(file.string()), load::kindOf(load::textOf(start)),
                             extension.empty() ? "none" : load::printable(extension)));
}

}  // namespace

Scene loadScene(const fs::path& file, const LoadSettings& settings) {
    validate(settings);
    Scene::Data data = loadByFormat(file, settings);
    try {
        return Scene{std::move(data), settings};
    } catch (const Error& error) {
        throw Error{error.kind(), fmt::format("{}: {}", file.string(), error.what())};
    }
}

}  // namespace inkedge
