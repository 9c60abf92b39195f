#pragma once

#include <inkedge/settings.h>

#include "passes/detect_edges.h"
#include "passes/read_maps.h"
#include "raster/tiles.h"
#include "render/styles.h"
#include "settings/picture_channels.h"
#include "trace/trace_lines.h"

namespace inkedge::render {

/// Where the lines of a picture come from.
enum class LineSource {
    None,
    Planes,    ///< traced between pixels whose planes do not go on into each other
    Classic,   ///< pixels marked by gradients of the depth map and of the normal map
    Profiles,  ///< ink of Detector::SaitoTakahashi
    Fattened,  ///< ink of Detector::RaskarCohen
    Object,    ///< the mesh itself
};

/// What is drawn, found and inked for a picture and its maps: decided once, from the settings alone.
struct Plan {
    LineSource lines = LineSource::None;
    const StyleRow* style = &styleRow(Style::Ink);

    // What the triangles are drawn into, tile by tile.
    bool planes = false;
    bool surface = false;
    bool planesOfPixels = false;      ///< planes for the maps, where those for lines are of smaller samples
    bool together = false;            ///< the surface and the planes that the maps come from by one pass
    bool functions = false;           ///< DetectorSettings::functions, one after the other
    int margin = raster::tileMargin;  ///< samples around a tile that its passes need

    bool fattened = false;      ///< LineSource::Fattened
    Shade shade = Shade::None;  ///< under the lines, or for its map

    // What is found in it.
    bool tracesLines = false;  ///< lines between planes: strokes, Maps::types, Maps::ids, Maps::edges
    trace::TraceIds ids = trace::TraceIds::Drop;
    bool detectsEdges = false;  ///< edges of the depth map and of the normal map
    passes::Magnitudes magnitudes = passes::Magnitudes::Drop;

    // What of it is kept in the maps.
    passes::SurfaceMaps surfaceMaps;
    passes::EdgeMaps edgeMaps;
    bool types = false;
    bool mapsBeside = false;  ///< Maps::types and ::edges have the drawn ones of lines::typesAddedToMaps
    bool lineMask = false;    ///< Maps::edges has the lines that are traced
    bool inkMask = false;     ///< Maps::edges has the ink of functions, profiles and styles

    bool underlaid = false;  ///< the picture has the shade under its lines

    settings::Paper paper = settings::Paper::Background;  ///< of what is drawn before the last steps

    [[nodiscard]] bool drawsTiles() const noexcept {
        return planes || planesOfPixels || surface || functions || fattened || style->tileInk != nullptr ||
               shade != Shade::None;
    }
    /// Lines from object space, and pictures of nothing else, need none.
    [[nodiscard]] bool needsContext() const noexcept { return drawsTiles() || style->redraw != nullptr; }
};

[[nodiscard]] Plan planOf(const RenderSettings&);

/// What is drawn of the shade of Lines.
[[nodiscard]] Plan planOfShade(const RenderSettings&);

/// What is drawn for Lines from image space: no map, no picture, whatever its style.
[[nodiscard]] Plan planOfImageLines();

/// Whether a map is asked for.
[[nodiscard]] bool wants(const RenderSettings&, Map);

}  // namespace inkedge::render
