#include "io/map_layers.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <inkedge/error.h>

namespace inkedge::io {
namespace {

// Calls a function with the image of a map, which Maps or const Maps hold.
template <class MapsType, class Function>
auto onImage(MapsType& maps, Map map, Function function) {
    switch (map) {
        case Map::Depth:
            return function(maps.depth);
        case Map::Normal:
            return function(maps.normal);
        case Map::DepthEdges:
            return function(maps.depthEdges);
        case Map::NormalEdges:
            return function(maps.normalEdges);
        case Map::Types:
            return function(maps.types);
        case Map::Ids:
            return function(maps.ids);
        case Map::Shade:
            return function(maps.shade);
        case Map::Edges:
            break;
    }
    return function(maps.edges);
}

// They end in one letter: Blender drops other layers.
std::vector<std::string> channelsOf(Map map) {
    switch (map) {
        case Map::Depth:
            return {"depth.Z"};
        case Map::Normal:
            return {"normal.X", "normal.Y", "normal.Z"};
        case Map::Types:
            return {"types.V"};
        case Map::Shade:
            return {"shade.R", "shade.G", "shade.B", "shade.A"};
        default:
            return {fmt::format("{}.Y", name(map))};
    }
}

}  // namespace

std::vector<MapLayer> layersOf(const Maps& maps, Map map) {
    const std::vector<std::string> files = layerFiles(map);
    const AnyImagePointer image = imageOf(maps, map);
    if (map != Map::Ids) return {{map, files.front(), {image, channelsOf(map)}}};
    std::vector<MapLayer> layers;
    for (std::size_t c = 0; c < idNames.size(); ++c)
        layers.push_back({map, files[c], {image, {fmt::format("{}.V", idNames[c])}, static_cast<int>(c)}});
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

namespace inkedge {

AnyImagePointer imageOf(const Maps& maps, Map map) noexcept {
    return io::onImage(maps, map, [](const auto& image) -> AnyImagePointer { return &image; });
}

AnyImage takeImage(Maps& maps, Map map) noexcept {
    return io::onImage(maps, map, [](auto& image) -> AnyImage { return std::move(image); });
}

}  // namespace inkedge
