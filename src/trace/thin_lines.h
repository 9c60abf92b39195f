#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <inkedge/camera.h>
#include <inkedge/image.h>
#include <inkedge/line_types.h>
#include <inkedge/scene.h>

#include "trace/join_cells.h"
#include "trace/line_buffers.h"
#include "trace/replace_samples.h"
#include "trace/screen_triangles.h"
#include "trace/thin_parts.h"
#include "trace/traced_piece.h"

namespace inkedge::trace {

/// Marks, besides those given, around the thin parts of a tile: what has to be read to trace these.
[[nodiscard]] Image<std::uint8_t> withThinParts(Image<std::uint8_t> marks, std::span<const ThinStretch>,
                                                const raster::Tile&, int samplesPerPixel);

/// A thin stretch that is seen.
struct ThinLine {
    ThinStretch stretch;
    LineTypes types;
    std::array<float, 2> inverseDepths;  ///< at its ends, as TracedPiece has them
};

/// The thin parts of a tile that are seen, alone: to both sides there is something farther away, nothing, another thin
/// part, or a surface that they lie on and are not connected to. What else a thin part has beside it at its own depth
/// belongs to the same surface, whose lines samples see. And the gaps that have their surface on both sides.
[[nodiscard]] std::vector<ThinLine> seeThinParts(const LineBuffers&, std::span<const ThinStretch>, const Scene&,
                                                 const ScreenTriangles&, const Camera&, int samplesPerPixel);

/// The samples that see these thin parts, or through these gaps. They are to show what is beside, so that lines behind
/// go on there.
[[nodiscard]] std::vector<Replacement> samplesOn(std::span<const ThinLine>, const LineBuffers&, const ScreenTriangles&,
                                                 const Camera&, int samplesPerPixel);

/// Draws thin parts. Up to half a pixel they are their middle lines, as thin as they are. From there on two lines part,
/// and widen, until at a pixel they are the contours that samples see: ink grows steadily with the thickness. Adds the
/// pieces of those whose middle the tile keeps, and their types to the map of the samples that the tile draws. The two
/// borders of a gap are both whole, so that the line in its middle is.
void addThinLines(std::span<const ThinLine>, const raster::Tile&, DrawnTypes, int samplesPerPixel,
                  Image<std::uint16_t>& types, std::vector<TracedPiece>&);

}  // namespace inkedge::trace
