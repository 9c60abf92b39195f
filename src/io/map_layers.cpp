#include "io/map_layers.h"

#include <algorithm>

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::io {
namespace {

// The names of channels end in one letter: Blender drops other layers.
images::Layer valuesOf(const Maps& maps, Map map) {
    switch (map) {
        case Map::Depth:
            return {&maps.depth, {"depth.Z"}};
        case Map::Normal:
            return {&maps.normal, {"normal.X", "normal.Y", "normal.Z"}};
        case Map::DepthEdges:
            return {&maps.depthEdges, {"depth-edges.Y"}};
        case Map::NormalEdges:
            return {&maps.normalEdges, {"normal-edges.Y"}};
        case Map::Types:
            return {&maps.types, {"types.V"}};
        case Map::Ids:
            return {&maps.ids, {}};
        case Map::Shade:
            return {&maps.shade, {"shade.R", "shade.G", "shade.B", "shade.A"}};
        case Map::Edges:
            break;
    }
    return {&maps.edges, {"edges.Y"}};
}

}  // namespace

std::vector<MapLayer> layersOf(const Maps& maps, Map map) {
    const std::vector<std::string> files = layerFiles(map);
    const images::Layer values = valuesOf(maps, map);
    if (map != Map::Ids) return {{map, files.front(), values}};
    std::vector<MapLayer> layers;
    for (std::size_t c = 0; c < idNames.size(); ++c)
        layers.push_back({map, files[c], {values.image, {fmt::format("{}.V", idNames[c])}, static_cast<int>(c)}});
    return layers;
}

std::vector<std::string> layerFiles(Map map) {
    if (map != Map::Ids) return {std::string{name(map)}};
    std::vector<std::string> files;
    for (const std::string_view channel : idNames) files.push_back(fmt::format("{}-{}", name(map), channel));
    return files;
}

std::string arrayName(Map map) {
    std::string text{name(map)};
    std::ranges::replace(text, '-', '_');
    return text;
}

void expectIdsUpTo(std::uint32_t max, std::string_view because, const MapLayer& layer,
                   const std::filesystem::path& target) {
    if (layer.map != Map::Ids) return;
    const auto& ids = *std::get<const Image<std::uint32_t>*>(layer.values.image);
    std::uint32_t largest = 0;
    for (std::size_t i = static_cast<std::size_t>(layer.values.first); i < ids.pixels().size(); i += idNames.size())
        largest = std::max(largest, ids.pixels()[i]);
    if (largest <= max) return;
    throw Error{
        Error::Kind::Output,
        fmt::format("{}: map ids: expected numbers up to {}, {}, found {} {}; write an .npz, leave ids out of "
                    "the maps, or load a part of the model",
                    target.string(), max, because, idNames[static_cast<std::size_t>(layer.values.first)], largest)};
}

}  // namespace inkedge::io
