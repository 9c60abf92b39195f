#include "trace/trace_lines.h"

#include <cmath>
#include <utility>

#include <glm/trigonometric.hpp>

#include "base/stop.h"
#include "trace/crossings.h"
#include "trace/pinholes.h"
#include "trace/slivers.h"
#include "trace/thin_lines.h"
#include "trace/trace_maps.h"

namespace inkedge::trace {

TracedLines traceLines(LineBuffers buffers, const Scene& scene, const ScreenTriangles& triangles,
                       std::span<const ThinStretch> thin, const Camera& camera, double unit, DrawnTypes types,
                       int samplesPerPixel, TraceIds ids) {
    TracedLines traced;
    const raster::Tile tile = buffers.tile;
    const glm::dvec2 focal = camera.focalLengths(tile.whole) * (camera.orthographic() ? unit : 1.0);
    const raster::PlaneView view{focal, camera.orthographic(), std::cos(glm::radians(scene.creaseAngle()))};
    removePinholes(buffers, camera, unit);
    if (ids == TraceIds::Keep) traced.ids = raster::cropped(traceIds(buffers, scene, triangles), tile.keptInDrawn());
    const std::vector<ThinLine> thinLines = seeThinParts(buffers, thin, scene, triangles, camera, samplesPerPixel);
    std::vector<Replacement> replaced = findSlivers(buffers, triangles);
    const std::vector<Replacement> onThin = samplesOn(thinLines, buffers, triangles, camera, samplesPerPixel);
    replaced.insert(replaced.end(), onThin.begin(), onThin.end());
    replaceSamples(buffers, view, camera.centre(tile.whole), replaced);

    CrossingTracer tracer{buffers, triangles, camera};
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
    Image<std::uint16_t> typesOfSamples = tracer.takeTypes();
    addThinLines(thinLines, tile, types, samplesPerPixel, typesOfSamples, traced.pieces);
    traced.types = raster::cropped(std::move(typesOfSamples), tile.keptInDrawn());
    return traced;
}

}  // namespace inkedge::trace
