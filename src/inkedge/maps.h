#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <inkedge/backends.h>
#include <inkedge/camera.h>
#include <inkedge/export.h>
#include <inkedge/image.h>
#include <inkedge/line_types.h>
#include <inkedge/scene_names.h>
#include <inkedge/settings.h>
#include <inkedge/stage_time.h>

namespace inkedge {

/// The result of one render. Every image has the picture's size, row 0 at the top; maps that were not asked for are
/// empty. The masks hold 255 on an edge and 0 off it.
struct Maps {
    /// 4 channels (RGBA, not premultiplied) if the background is transparent; else 1 (grey) if all lines and the
    /// background are grey and there is no shade; else 3 (RGB).
    Image<std::uint8_t> picture;
    Image<float> depth;        ///< eye-space depth, scene units; background: camera.far
    Image<float> windowDepth;  ///< 0 at near, 1 at far; background: 1
    /// 3 channels, -1..1, unit length, turned to the side that is seen, in RenderSettings::normalSpace; background: 0.
    Image<float> normal;
    Image<float> depthMagnitude;      ///< Hertzmann 1999, equation 6, of the depth map
    Image<float> normalMagnitude;     ///< equation 6 of the normal map: the largest of the three channels
    Image<std::uint8_t> depthEdges;   ///< equation 7 of the depth map
    Image<std::uint8_t> normalEdges;  ///< equation 7 of the normal map
    /// Depth edges or normal edges: Figure 1(e). With the planes detector: pixels on a line.
    Image<std::uint8_t> edges;
    Image<std::uint16_t> types;  ///< LineTypes::bits() at pixels on the nearer side of a line, else 0
    /// 4 channels: the patch of the pixel; the patch across the line, 0 off lines; the instance; the material. Each
    /// counts from 1; 0 is none or background.
    Image<std::uint32_t> ids;
    /// 4 channels, sRGB, not premultiplied: what lies under the lines, or would with Shade::Gooch if the picture has no
    /// shade; background: 0. Unlike the other maps it is the mean of a pixel's samples.
    Image<std::uint8_t> shade;
    /// Of the lines that are drawn and seen; zero where a detector leaves none, but pixels.
    LineLengths lengths{};
    SceneNames names;  ///< what the ids stand for: namesOf() the scene; empty unless ids were asked for

    Camera camera;
    std::optional<double> dpi;  ///< pixels per inch that files of it tell: PictureSettings::dpi
    BackendInfo backend;
    std::vector<StageTime> times;
    /// One line each: what the settings ask for and the scene has nothing for, as renderWarnings() gives it.
    std::vector<std::string> warnings;
};

/// An image of whatever type of values a map has.
using AnyImage = std::variant<Image<std::uint8_t>, Image<std::uint16_t>, Image<std::uint32_t>, Image<float>>;
/// The same, held by another.
using AnyImagePointer = std::variant<const Image<std::uint8_t>*, const Image<std::uint16_t>*,
                                     const Image<std::uint32_t>*, const Image<float>*>;

/// The image of a map; empty if the map was not asked for.
[[nodiscard]] INKEDGE_API AnyImagePointer imageOf(const Maps&, Map) noexcept;

/// The same, moved out of Maps: it is empty there then.
[[nodiscard]] INKEDGE_API AnyImage takeImage(Maps&, Map) noexcept;

}  // namespace inkedge
