#pragma once

#include <functional>
#include <optional>

#include <inkedge/image.h>
#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "passes/draw_planes.h"
#include "passes/draw_surface.h"
#include "passes/frame.h"

namespace inkedge::render {

/// What the triangles of a tile are drawn into.
struct Geometry {
    std::optional<passes::PlaneBuffers> planes;          ///< in samples
    std::optional<passes::PlaneBuffers> planesOfPixels;  ///< of Plan::planesOfPixels
    std::optional<passes::SurfaceBuffers> surface;       ///< in pixels
};

/// The frames of a tile: for passes that work in samples, and for those that work in pixels.
struct TileFrames {
    passes::Frame samples;
    passes::Frame pixels;
};

/// Says how much of each pixel of a tile is inked, 0 to 255, from what the style needs drawn.
using TileInk = std::function<Image<std::uint8_t>(const TileFrames&, const Geometry&)>;

/// What a style needs, and its step. A style without a step draws the lines alone.
struct StyleRow {
    Style style;
    const char* stage;       ///< the name of its step in StageTime
    bool drawsLines = true;  ///< false: its step replaces the lines
    bool planes = false;     ///< its step reads Geometry::planes
    bool surface = false;    ///< its step reads Geometry::surface
    /// Pixels around a pixel that its step reads; null: fewer than every tile draws anyway.
    int (*reach)(const StyleSettings&) = nullptr;

    /// A step that inks tile by tile, made once for all tiles of a picture; null: none. The settings must outlive it.
    TileInk (*tileInk)(const Scene&, const RenderSettings&) = nullptr;
    /// A step that draws the whole picture anew, from what was drawn of it to a drawing, both on transparent paper;
    /// null: none.
    Image<std::uint8_t> (*redraw)(gl::Gpu&, const Image<std::uint8_t>& drawing, const RenderSettings&) = nullptr;
};

[[nodiscard]] const StyleRow& styleRow(Style);

}  // namespace inkedge::render
