#include <inkedge/write.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <inkedge/error.h>

#include "base/staged_files.h"
#include "images/encode_exr.h"
#include "io/encode_files.h"
#include "io/map_layers.h"
#include "io/map_pictures.h"
#include "io/npz.h"
#include "io/output_formats.h"
#include "io/picture.h"
#include "raster/memory.h"

namespace fs = std::filesystem;

namespace inkedge {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::string_view placeholder = "{map}";
constexpr std::string_view pictureName = "outline";

std::vector<Map> distinct(std::span<const Map> maps) {
    std::vector<Map> result;
    for (const Map map : maps) {
        if (std::find(result.begin(), result.end(), map) == result.end()) result.push_back(map);
    }
    return result;
}

/// @return whether output held the placeholder
bool substitute(std::string& output, std::string_view value) {
    bool found = false;
    for (std::size_t at = 0; (at = output.find(placeholder, at)) != std::string::npos; at += value.size()) {
        output.replace(at, placeholder.size(), value);
        found = true;
    }
    return found;
}

fs::path pictureFile(const fs::path& output) {
    std::string text = output.string();
    substitute(text, pictureName);
    return text;
}

fs::path layerFile(const fs::path& output, std::string_view layer) {
    std::string text = output.string();
    if (substitute(text, layer)) return text;
    return output.parent_path() / fmt::format("{}.{}{}", output.stem().string(), layer, output.extension().string());
}

std::vector<io::MapLayer> layersOf(const Maps& maps, std::span<const Map> wanted) {
    std::vector<io::MapLayer> layers;
    for (const Map map : wanted) {
        for (io::MapLayer& layer : io::layersOf(maps, map)) layers.push_back(std::move(layer));
    }
    return layers;
}

std::array<float, 16> rowMajor(const glm::dmat4& matrix) {
    std::array<float, 16> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(matrix[static_cast<int>(i % 4)][static_cast<int>(i / 4)]);
    return values;
}

std::vector<images::HeaderEntry> headerOf(const Maps& maps, std::span<const Map> wanted) {
    const Camera& camera = maps.camera;
    std::vector<images::HeaderEntry> entries{{"inkedge:near", static_cast<float>(camera.near)},
                                             {"inkedge:far", static_cast<float>(camera.far)},
                                             {"inkedge:view", rowMajor(camera.view)},
                                             {"inkedge:projection", rowMajor(camera.projection(maps.picture.size()))}};
    if (std::ranges::find(wanted, Map::Ids) != wanted.end())
        entries.push_back({"inkedge:names", namesJson(maps.names)});
    return entries;
}

Bytes exrOf(const Maps& maps, std::span<const Map> wanted, const fs::path& target) {
    const std::vector<io::MapLayer> layers = layersOf(maps, wanted);
    for (const io::MapLayer& layer : layers)
        io::expectIdsUpTo(io::maxExactFloat, "which the floats of an EXR hold exactly", layer, target);
    const int channels = std::max(maps.picture.channels(), 3);
    raster::expectMemory(maps.picture.size(), sizeof(float) * static_cast<std::uint64_t>(channels));
    const Image<float> picture = io::linearPicture(maps.picture);
    std::vector<images::Layer> all{{&picture, io::channelNames(picture.channels())}};
    const Image<float> shade = io::linearPicture(maps.shade);
    for (const io::MapLayer& layer : layers)
        all.push_back(layer.map == Map::Shade ? images::Layer{&shade, layer.values.channels} : layer.values);
    return images::encodeExr(all, headerOf(maps, wanted));
}

template <class Matrix>
void addMatrix(io::NpzWriter& arrays, std::string_view name, const Matrix& matrix) {
    constexpr auto size = static_cast<std::size_t>(Matrix::length());
    std::vector<double> values;
    for (int row = 0; row < Matrix::length(); ++row) {
        for (int column = 0; column < Matrix::length(); ++column) values.push_back(matrix[column][row]);
    }
    arrays.add<double>(name, {size, size}, values);
}

void addCamera(io::NpzWriter& arrays, const Camera& camera, Size size) {
    addMatrix(arrays, "view", camera.view);
    addMatrix(arrays, "projection", camera.projection(size));
    addMatrix(arrays, "world_to_camera", camera.worldToCamera());
    addMatrix(arrays, "K", camera.intrinsics(size));
    arrays.add<double>("near", {}, std::span{&camera.near, 1});
    arrays.add<double>("far", {}, std::span{&camera.far, 1});
    arrays.add<double>("orthographic_height", {}, std::span{&camera.orthographicHeight, 1});  // as in the metadata
}

// By id, so that names[ids] are the names: 0 stands for none.
void addNames(io::NpzWriter& arrays, const SceneNames& names) {
    std::vector<std::string> nodes(names.instances.empty() ? 1 : names.instances.back().id + 1);
    for (const NamedInstance& instance : names.instances) nodes[instance.id] = instance.node;
    arrays.addTexts("instance_names", nodes);
    std::vector<std::string> materials{""};
    materials.insert(materials.end(), names.materials.begin(), names.materials.end());
    arrays.addTexts("material_names", materials);
}

Bytes npzOf(const Maps& maps, std::span<const Map> wanted) {
    io::NpzWriter arrays;
    arrays.add("picture", maps.picture);
    for (const Map map : wanted) {
        std::visit([&](const auto* each) { arrays.add(io::arrayName(map), *each); }, imageOf(maps, map));
    }
    addCamera(arrays, maps.camera, maps.picture.size());
    if (std::ranges::find(wanted, Map::Ids) != wanted.end()) addNames(arrays, maps.names);
    return std::move(arrays).take();
}

void expectRendered(const Maps& maps, std::span<const Map> wanted) {
    const Size expected = maps.picture.size();
    if (maps.picture.empty())
        throw Error{Error::Kind::Usage, "picture: expected at least one pixel, found none; was it rendered?"};
    for (const Map map : wanted) {
        const Size found = io::layersOf(maps, map).front().values.size();
        if (found != expected)
            throw Error{Error::Kind::Usage,
                        fmt::format("map {}: expected {} x {} pixels, found {} x {}; was it rendered?", name(map),
                                    expected.width, expected.height, found.width, found.height)};
    }
}

}  // namespace

std::vector<fs::path> outputFiles(const fs::path& output, std::span<const Map> maps) {
    io::expectOutputFormat(output);
    std::vector<fs::path> files{pictureFile(output)};
    if (io::holdsAllMaps(io::pictureFormat(output))) return files;
    for (const Map map : distinct(maps)) {
        for (const std::string& layer : io::layerFiles(map)) files.push_back(layerFile(output, layer));
    }
    return files;
}

std::vector<Map> defaultMaps(const fs::path& output) {
    if (io::formatOf<io::PictureFormat>(output) != io::PictureFormat::Npz) return {};
    return {Map::Depth, Map::Normal, Map::Types, Map::Ids, Map::Edges};
}

void io::encodeMaps(const Maps& maps, std::span<const Map> wanted, std::span<const fs::path> files,
                    const TakeFile& take) {
    const std::vector<Map> each = distinct(wanted);
    expectRendered(maps, each);
    const io::PictureFormat format = io::pictureFormat(files.front());
    if (io::holdsAllMaps(format)) {
        const fs::path& file = files.front();
        return take(file, format == io::PictureFormat::Npz ? npzOf(maps, each) : exrOf(maps, each, file));
    }
    take(files.front(), io::encodePicture(maps.picture, files.front(), maps.dpi));
    std::size_t next = 1;
    for (const io::MapLayer& layer : ::inkedge::layersOf(maps, each)) {
        const fs::path& file = files[next++];
        take(file,
             format == io::PictureFormat::Tiff ? io::tiffOf(layer, maps.dpi, file) : io::pngOf(maps, layer, file));
    }
}

std::vector<fs::path> writeMaps(const Maps& maps, std::span<const Map> wanted, const fs::path& output) {
    std::vector<fs::path> files = outputFiles(output, wanted);
    base::StagedFiles staged;
    io::encodeMaps(maps, wanted, files, [&](const fs::path& file, auto bytes) { staged.add(file, bytes); });
    staged.commit();
    return files;
}

}  // namespace inkedge
