#include <inkedge/write.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <string_view>

#include <inkedge/error.h>

#include "base/staged_files.h"
#include "images/encode_exr.h"
#include "io/output_formats.h"
#include "io/picture.h"
#include "io/write_map_files.h"
#include "raster/memory.h"

namespace fs = std::filesystem;

namespace inkedge {
namespace {

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

fs::path mapFile(const fs::path& output, Map map) {
    std::string text = output.string();
    if (substitute(text, name(map))) return text;
    return output.parent_path() /
           fmt::format("{}.{}{}", output.stem().string(), name(map), output.extension().string());
}

/// A share from 0 to 1 as a level from 0 to 255, rounded; NaN counts as 0.
std::uint8_t level(double share) {
    return static_cast<std::uint8_t>(share > 0.0 ? 255.0 * std::min(share, 1.0) + 0.5 : 0.0);
}

Image<std::uint8_t> depthPicture(const Image<float>& depth, const Camera& camera) {
    const double range = camera.far - camera.near;
    Image<std::uint8_t> picture{depth.size(), 1};
    std::transform(depth.pixels().begin(), depth.pixels().end(), picture.mutablePixels().begin(),
                   [&](float value) { return level((value - camera.near) / range); });
    return picture;
}

Image<std::uint8_t> normalPicture(const Image<float>& normal) {
    Image<std::uint8_t> picture{normal.size(), normal.channels()};
    std::transform(normal.pixels().begin(), normal.pixels().end(), picture.mutablePixels().begin(),
                   [](float value) { return level((value + 1.0) / 2.0); });
    return picture;
}

Image<std::uint8_t> edgePicture(const Image<std::uint8_t>& mask) {
    Image<std::uint8_t> picture{mask.size(), 1};
    std::transform(mask.pixels().begin(), mask.pixels().end(), picture.mutablePixels().begin(),
                   [](std::uint8_t value) { return static_cast<std::uint8_t>(255 - value); });
    return picture;
}

/// One colour for each combination of bits: outlines red, occlusions green, creases blue and so on; white off lines.
Image<std::uint8_t> typesPicture(const Image<std::uint16_t>& types) {
    constexpr std::array<std::array<int, 3>, lineTypeCount> inks{{{220, 30, 30},
                                                                  {20, 150, 40},
                                                                  {230, 140, 0},
                                                                  {30, 70, 220},
                                                                  {160, 40, 180},
                                                                  {20, 170, 180},
                                                                  {120, 120, 120},
                                                                  {90, 60, 30}}};
    Image<std::uint8_t> picture{types.size(), 3, std::uint8_t{255}};
    for (std::size_t i = 0; i < types.pixels().size(); ++i) {
        const LineTypes known = LineTypes::fromBits(types.pixels()[i]) & allLineTypes;
        if (known.empty()) continue;
        const auto& ink = inks[static_cast<std::size_t>(bitIndex(known.first()))];
        for (std::size_t k = 0; k < 3; ++k) picture.mutablePixels()[3 * i + k] = static_cast<std::uint8_t>(ink[k]);
    }
    return picture;
}

/// A colour for each patch, scattered so that neighbours differ; white on the background.
Image<std::uint8_t> patchPicture(const Image<std::uint32_t>& ids) {
    Image<std::uint8_t> picture{ids.size(), 3, std::uint8_t{255}};
    for (std::size_t i = 0; 4 * i < ids.pixels().size(); ++i) {
        const std::uint32_t patch = ids.pixels()[4 * i];
        if (patch == 0) continue;
        const std::uint32_t scattered = patch * 2654435761U;
        for (std::size_t k = 0; k < 3; ++k) {
            picture.mutablePixels()[3 * i + k] = static_cast<std::uint8_t>(64 + ((scattered >> (8 * k + 8)) & 127U));
        }
    }
    return picture;
}

Image<std::uint8_t> mapPicture(const Maps& maps, Map map) {
    switch (map) {
        case Map::Depth:
            return depthPicture(maps.depth, maps.camera);
        case Map::Normal:
            return normalPicture(maps.normal);
        case Map::DepthEdges:
            return edgePicture(maps.depthEdges);
        case Map::NormalEdges:
            return edgePicture(maps.normalEdges);
        case Map::Types:
            return typesPicture(maps.types);
        case Map::Ids:
            return patchPicture(maps.ids);
        case Map::Edges:
            break;
    }
    return edgePicture(maps.edges);
}

/// A layer of an EXR. The names of its channels end in one letter: Blender drops other layers. Ids are floats: beside
/// floats OpenImageIO reads integers as shares of the largest one, unless it is told not to.
images::Layer mapLayer(const Maps& maps, Map map) {
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
            return {&maps.ids, {"patch.V", "across.V", "object.V", "material.V"}};
        case Map::Edges:
            break;
    }
    return {&maps.edges, {"edges.Y"}};
}

std::array<float, 16> rowMajor(const glm::dmat4& matrix) {
    std::array<float, 16> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(matrix[static_cast<int>(i % 4)][static_cast<int>(i / 4)]);
    return values;
}

std::vector<images::HeaderEntry> cameraEntries(const Camera& camera, Size size) {
    return {{"inkedge:near", static_cast<float>(camera.near)},
            {"inkedge:far", static_cast<float>(camera.far)},
            {"inkedge:view", rowMajor(camera.view)},
            {"inkedge:projection", rowMajor(camera.projection(size))}};
}

void expectExactIds(const Image<std::uint32_t>& ids, const fs::path& target) {
    constexpr std::uint32_t largest = 1U << std::numeric_limits<float>::digits;  // with all below it exact as a float
    const auto found = std::max_element(ids.pixels().begin(), ids.pixels().end());
    if (found == ids.pixels().end() || *found <= largest) return;
    constexpr std::array names{"patch", "patch", "node", "material"};
    throw Error{Error::Kind::Output,
                fmt::format("{}: map ids: expected numbers up to {}, which the floats of an EXR hold exactly, found {} "
                            "{}; leave ids out of the maps, or load a part of the model",
                            target.string(), largest, names[static_cast<std::size_t>(found - ids.pixels().begin()) % 4],
                            *found)};
}

std::vector<std::uint8_t> encodeLayers(const Maps& maps, std::span<const Map> wanted, const fs::path& target) {
    if (std::find(wanted.begin(), wanted.end(), Map::Ids) != wanted.end()) expectExactIds(maps.ids, target);
    const int channels = std::max(maps.picture.channels(), 3);
    raster::expectMemory(maps.picture.size(), sizeof(float) * static_cast<std::uint64_t>(channels));
    const Image<float> picture = io::linearPicture(maps.picture);
    std::vector<images::Layer> layers{{&picture, io::channelNames(picture.channels())}};
    for (const Map map : wanted) layers.push_back(mapLayer(maps, map));
    return images::encodeExr(layers, cameraEntries(maps.camera, picture.size()));
}

void expectSize(Size found, Size expected, std::string_view map) {
    if (found == expected) return;
    throw Error{Error::Kind::Usage, fmt::format("map {}: expected {} x {} pixels, found {} x {}; was it rendered?", map,
                                                expected.width, expected.height, found.width, found.height)};
}

void expectRendered(const Maps& maps, std::span<const Map> wanted) {
    if (maps.picture.empty()) {
        throw Error{Error::Kind::Usage, "picture: expected at least one pixel, found none; was it rendered?"};
    }
    for (const Map map : wanted) {
        const Size size = std::visit([](const auto* image) { return image->size(); }, mapLayer(maps, map).image);
        expectSize(size, maps.picture.size(), name(map));
    }
}

}  // namespace

std::vector<fs::path> outputFiles(const fs::path& output, std::span<const Map> maps) {
    io::expectOutputFormat(output);
    const io::PictureFormat format = io::pictureFormat(output);
    std::vector<fs::path> files{pictureFile(output)};
    if (format == io::PictureFormat::OpenExr) return files;
    for (const Map map : distinct(maps)) files.push_back(mapFile(output, map));
    return files;
}

void io::writeMapFiles(const Maps& maps, std::span<const Map> wanted, std::span<const fs::path> files) {
    const std::vector<Map> each = distinct(wanted);
    expectRendered(maps, each);

    base::StagedFiles staged;
    if (io::pictureFormat(files.front()) == io::PictureFormat::OpenExr) {
        staged.add(files.front(), encodeLayers(maps, each, files.front()));
    } else {
        staged.add(files.front(), io::encodePicture(maps.picture, files.front(), maps.dpi));
        for (std::size_t i = 0; i < each.size(); ++i) {
            staged.add(files[i + 1], io::encodePicture(mapPicture(maps, each[i]), files[i + 1], maps.dpi));
        }
    }
    staged.commit();
}

std::vector<fs::path> writeMaps(const Maps& maps, std::span<const Map> wanted, const fs::path& output) {
    std::vector<fs::path> files = outputFiles(output, wanted);
    io::writeMapFiles(maps, wanted, files);
    return files;
}

}  // namespace inkedge
