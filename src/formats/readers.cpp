#include <array>
#include <string_view>

#include "formats/gltf/load_gltf.h"
#include "formats/polygons/load_polygons.h"
#include "formats/reader.h"

namespace inkedge {
namespace load {
namespace {

using namespace std::string_view_literals;

constexpr std::array gltfExtensions{".glb"sv, ".gltf"sv};
constexpr std::array gltfStarts{"glTF"sv};
constexpr std::array objExtensions{".obj"sv};
constexpr std::array stlExtensions{".stl"sv};
constexpr std::array stlStarts{"solid "sv, "solid\n"sv, "solid\r"sv};
constexpr std::array plyExtensions{".ply"sv};
constexpr std::array plyStarts{"ply\n"sv, "ply\r"sv};

template <PolygonFormat format>
Scene::Data readPolygons(const ModelInput& input, const LoadSettings& settings) {
    return loadPolygons(input, format, settings.limits,
                        settings.textureCoordinates ? Coordinates::Read : Coordinates::Skip);
}

constexpr std::array table{
    Reader{.format = {"glTF 2.0", gltfExtensions},
           .firstBytes = gltfStarts,
           .firstBytesAreCertain = true,
           .unit = LengthUnit::Metre,
           .knowsSides = true,
           .read = loadGltf},
    Reader{.format = {name(PolygonFormat::Obj), objExtensions}, .read = readPolygons<PolygonFormat::Obj>},
    Reader{.format = {name(PolygonFormat::Stl), stlExtensions},
           .firstBytes = stlStarts,
           .read = readPolygons<PolygonFormat::Stl>},
    Reader{.format = {name(PolygonFormat::Ply), plyExtensions},
           .firstBytes = plyStarts,
           .read = readPolygons<PolygonFormat::Ply>},
};

constexpr auto formats = [] {
    std::array<ModelFormat, table.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = table[i].format;
    return all;
}();

}  // namespace

std::span<const Reader> readers() noexcept { return table; }

}  // namespace load

std::span<const ModelFormat> readableFormats() noexcept { return load::formats; }

}  // namespace inkedge
