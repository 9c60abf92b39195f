#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/image.h>
#include <inkedge/lines.h>
#include <inkedge/settings.h>

#include "io/page.h"
#include "io/path.h"

namespace inkedge::io {

/// A path, and the width of the pen that draws it.
struct DrawnPath {
    Path path;
    double width;                         ///< pixels; of no meaning in a filled layer
    std::optional<std::uint32_t> object;  ///< as Line::object; none: it is no line of the model
};

/// Paths of one kind and one ink. Lengths are pixels; paths count from the layer's origin.
struct Layer {
    std::string name;     ///< "crease-hidden"
    std::string classes;  ///< of a style sheet: "crease hidden crease-hidden"
    Color color;
    double width = 0.0;   ///< of most of its paths
    double dash = 0.0;    ///< length of a dash's centre line; 0: solid lines
    double gap = 0.0;     ///< between two dashes
    bool filled = false;  ///< paths are outlines of areas that are inked; else they are drawn by a pen with a round tip
    glm::dvec2 origin{0.0};  ///< on the page
    std::string view;        ///< of several on a page: which; empty: there is one
    std::vector<DrawnPath> paths;
};

/// A picture, a pixel wide a pixel, under the layers.
struct DrawnImage {
    const Image<std::uint8_t>* pixels;  ///< 1, 3 or 4 channels, alpha not premultiplied
    glm::dvec2 origin;                  ///< of its top left corner on the page
};

/// What SVG, PDF and DXF write. It refers to the lines that it was made of, which must outlive it.
struct Drawing {
    Page page;
    std::string title;  ///< valid UTF-8
    std::string description;
    std::string metadata;  ///< JSON
    std::optional<Color> background;
    std::vector<DrawnImage> images;
    std::vector<Layer> layers;   ///< what comes later covers what comes before
    std::optional<Size> window;  ///< ink beyond this rectangle from a layer's origin is cut off; none: nothing is
    std::map<std::uint32_t, std::string_view> names;  ///< of objects
    double step = 0.1;                                ///< pixels: what coordinates may be rounded to
};

/// What becomes of lines whose width varies.
enum class VaryingWidths {
    Outlines,  ///< each stroke is a filled outline
    Centres,   ///< centre lines, as wide as their pen
};

/// Lines as layers.
struct LineLayers {
    std::vector<Layer> layers;
    bool isCut = false;  ///< whether some ink lies beyond the picture's edges
};

/// The lines that settings.picture.lines and settings.lines.hidden name, by type and visibility, what covers last; cut
/// at the picture's edges and half a width beyond; as polylines or curves within settings.lines.simplify, less
/// Lines::tolerance, or .fitCurves.
/// @param origin  where on the page the picture's top left corner lies
[[nodiscard]] LineLayers layersOf(const Lines&, const PictureSettings&, const LineSettings&, VaryingWidths,
                                  glm::dvec2 origin);

/// What coordinates may be rounded to, pixels: half a tenth is a fifth of the usual tolerance.
[[nodiscard]] double stepFor(const LineSettings&, VaryingWidths) noexcept;

/// The names of the instances that lines lie on.
[[nodiscard]] std::map<std::uint32_t, std::string_view> objectNames(const SceneNames&);

/// A picture of lines on the page that the settings ask for, above its background and Lines::shade.
/// @throws Error  (Kind::Usage) if lines.size has no pixel, or settings.lines.brush is given: it needs pixels
[[nodiscard]] Drawing drawingOf(const Lines&, const Settings&, std::string_view title, VaryingWidths);

}  // namespace inkedge::io
