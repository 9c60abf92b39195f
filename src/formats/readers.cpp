#include <array>
#include <string_view>

#include "formats/cad/load_cad.h"
#include "formats/gltf/load_gltf.h"
#include "formats/implicit/load_implicit.h"
#include "formats/polygons/load_polygons.h"
#include "formats/reader.h"

namespace inkedge {
namespace formats {
namespace {

using namespace std::string_view_literals;

constexpr std::array gltfExtensions{".glb"sv, ".gltf"sv};
constexpr std::array gltfStarts{"glTF"sv};
constexpr std::array objExtensions{".obj"sv};
constexpr std::array stlExtensions{".stl"sv};
constexpr std::array stlStarts{"solid "sv, "solid\n"sv, "solid\r"sv};
constexpr std::array plyExtensions{".ply"sv};
constexpr std::array plyStarts{"ply\n"sv, "ply\r"sv};

constexpr std::array stepExtensions{".step"sv, ".stp"sv, ".p21"sv};
constexpr std::array stepStarts{"ISO-10303-21"sv};
constexpr std::array igesExtensions{".iges"sv, ".igs"sv};
constexpr std::array brepExtensions{".brep"sv};
constexpr std::array brepStarts{"DBRep_DrawableShape"sv, "CASCADE Topology V"sv, "\nCASCADE Topology V"sv,
                                "Open CASCADE Topology V"sv, "\nOpen CASCADE Topology V"sv};

constexpr std::array threeMfExtensions{".3mf"sv};
constexpr std::array threeMfStarts{"PK\x03\x04"sv};

constexpr std::array implicitExtensions{".implicit"sv};

// CAD programs, and printers of solids, stand models on the xy plane.
constexpr glm::dvec3 zUp{0.0, 0.0, 1.0};

template <polygons::PolygonFormat format>
Scene::Data readPolygons(const ModelInput& input, const LoadSettings& settings) {
    return polygons::loadPolygons(
        input, format, settings.limits,
        settings.textureCoordinates ? polygons::Coordinates::Read : polygons::Coordinates::Skip);
}

constexpr std::array table{
    Reader{.format = {"glTF 2.0", gltfExtensions},
           .firstBytes = gltfStarts,
           .firstBytesAreCertain = true,
           .unit = LengthUnit::Metre,
           .knowsSides = true,
           .read = gltf::loadGltf},
    Reader{.format = {polygons::name(polygons::PolygonFormat::Obj), objExtensions},
           .read = readPolygons<polygons::PolygonFormat::Obj>},
    Reader{.format = {polygons::name(polygons::PolygonFormat::Stl), stlExtensions},
           .firstBytes = stlStarts,
           .up = zUp,
           .read = readPolygons<polygons::PolygonFormat::Stl>},
    Reader{.format = {polygons::name(polygons::PolygonFormat::Ply), plyExtensions},
           .firstBytes = plyStarts,
           .read = readPolygons<polygons::PolygonFormat::Ply>},
    Reader{.format = {"STEP", stepExtensions},
           .firstBytes = stepStarts,
           .firstBytesAreCertain = true,
           .unit = LengthUnit::Millimetre,
           .up = zUp,
           .read = cad::loadStep},
    Reader{.format = {"IGES", igesExtensions}, .unit = LengthUnit::Millimetre, .up = zUp, .read = cad::loadIges},
    Reader{.format = {"BREP", brepExtensions},
           .firstBytes = brepStarts,
           .firstBytesAreCertain = true,
           .unit = LengthUnit::Millimetre,
           .up = zUp,
           .read = cad::loadBrep},
    Reader{.format = {"3MF", threeMfExtensions},
           .firstBytes = threeMfStarts,
           .unit = LengthUnit::Millimetre,
           .up = zUp,
           .read = cad::loadThreeMf},
    Reader{.format = {"implicit surface", implicitExtensions}, .up = zUp, .read = implicit::loadImplicit},
};

constexpr auto formats = [] {
    std::array<ModelFormat, table.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = table[i].format;
    return all;
}();

}  // namespace

std::span<const Reader> readers() noexcept { return table; }

}  // namespace formats

std::span<const ModelFormat> readableFormats() noexcept { return formats::formats; }

}  // namespace inkedge
