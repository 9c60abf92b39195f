#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/camera.h>
#include <inkedge/image.h>
#include <inkedge/scene.h>

#include "trace/join_cells.h"
#include "trace/line_buffers.h"
#include "trace/screen_triangles.h"
#include "trace/thin_parts.h"
#include "trace/traced_piece.h"

namespace inkedge::trace {

/// What was found in a tile.
struct TracedLines {
    std::vector<TracedPiece> pieces;  ///< of cells that the tile keeps, in rows from the top
    Image<std::uint16_t> types;       ///< as Maps::types, of the samples that the tile keeps
    Image<std::uint32_t> ids;         ///< as Maps::ids, likewise; empty unless asked for
};

enum class TraceIds { Drop, Keep };

/// Finds each crossing between two neighbouring samples exactly where the planes meet or the nearer surface ends, and
/// what it is, and joins the crossings around each cell of 2 x 2 samples. joinPieces() makes lines of the pieces of all
/// tiles.
/// @param triangles       as the camera projects them onto the whole picture's samples
/// @param thin            as findThinParts() finds them; drawn as wide as they are
/// @param unit            scene units in a unit length of the planes
/// @param types           what becomes pieces; the maps hold all
[[nodiscard]] TracedLines traceLines(LineBuffers, const Scene&, const ScreenTriangles& triangles,
                                     std::span<const ThinStretch> thin, const Camera&, double unit, DrawnTypes types,
                                     int samplesPerPixel, TraceIds);

}  // namespace inkedge::trace
