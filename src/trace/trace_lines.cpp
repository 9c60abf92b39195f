#include "trace/trace_lines.h"

#include <utility>

#include "base/stop.h"
#include "trace/crossings.h"
#include "trace/pinholes.h"
#include "trace/slivers.h"
#include "trace/trace_maps.h"

namespace inkedge::trace {

TracedLines traceLines(LineBuffers buffers, const Scene& scene, const ScreenTriangles& triangles, const Camera& camera,
                       double unit, DrawnTypes types, int samplesPerPixel, TraceIds ids) {
    TracedLines traced;
    removePinholes(buffers, camera, unit);
    removeSlivers(buffers, triangles, camera, unit, scene.creaseAngle());
    CrossingTracer tracer{buffers, triangles, camera};
    const raster::Tile& tile = buffers.tile;
    const raster::Rectangle rows = aroundKept(tile);
    CellJoiner joiner{types, samplesPerPixel, tile, traced.pieces};
    CrossingRow above{tile.drawn.size.width};
    CrossingRow below{tile.drawn.size.width};
    tracer.traceRow(rows.y, above);
    for (int y = rows.y + 1; y < rows.y + rows.size.height; ++y) {
        base::stopIfAsked();
        tracer.traceRow(y, below);
        if (const int cells = y - 1 + tile.drawn.y; cells >= tile.kept.y) joiner.join(cells, above, below);
        std::swap(above, below);
    }
    traced.types = raster::cropped(tracer.takeTypes(), tile.keptInDrawn());
    if (ids == TraceIds::Keep) traced.ids = raster::cropped(traceIds(buffers, scene, triangles), tile.keptInDrawn());
    if (samplesPerPixel > 1) {
        if (ids == TraceIds::Keep) traced.ids = idsOfPixels(traced.ids, traced.types, samplesPerPixel);
        traced.types = typesOfPixels(traced.types, samplesPerPixel);
    }
    return traced;
}

}  // namespace inkedge::trace
