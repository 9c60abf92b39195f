#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

#include <inkedge/image.h>

#include "raster/samples.h"
#include "raster/tiles.h"

namespace inkedge::trace {

/// The halves of a sample's marks: of the edge to the sample at its right, and to the one below.
inline constexpr unsigned rightMarks = 0x0F;
inline constexpr unsigned belowMarks = 0xF0;

/// What the detector found, in samples: one a pixel, or 2 x 2 or 4 x 4. Row 0 is the tile's top row.
struct LineBuffers {
    raster::Tile tile;                         ///< what they show
    raster::Samples<float> planes;             ///< as PlaneBuffers::planes; needed where regionsAround() the marks are
    raster::Samples<std::uint32_t> triangles;  ///< as PlaneBuffers::triangles; likewise, everywhere for TraceIds::Keep
    Image<std::uint8_t> marks;                 ///< as detectLines() returns them
};

/// The kept part of a tile and the samples around it: crossings up to there count for the tile's lines and maps.
[[nodiscard]] inline raster::Rectangle aroundKept(const raster::Tile& tile) {
    const auto [x, y, size] = tile.keptInDrawn();
    const int left = std::max(x - 1, 0);
    const int top = std::max(y - 1, 0);
    return {left,
            top,
            {std::min(x + size.width + 1, tile.drawn.size.width) - left,
             std::min(y + size.height + 1, tile.drawn.size.height) - top}};
}

/// Calls visit(x) where a row of marks is not 0. Most marks are 0: eight of them are skipped at a time.
template <class Visit>
void forEachMarked(const Image<std::uint8_t>& marks, int y, int begin, int end, Visit visit) {
    const std::uint8_t* const row = &marks(0, y);
    constexpr int step = sizeof(std::uint64_t);
    for (int x = begin; x < end;) {
        std::uint64_t next = 1;
        if (x + step <= end) std::memcpy(&next, row + x, sizeof next);
        if (next == 0) {
            x += step;
            continue;
        }
        for (const int stop = std::min(x + step, end); x < stop; ++x) {
            if (row[x] != 0) visit(x);
        }
    }
}

}  // namespace inkedge::trace
