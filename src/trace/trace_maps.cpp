#include "trace/trace_maps.h"

#include "scene/prepared.h"

namespace inkedge::trace {

Image<std::uint32_t> traceIds(const LineBuffers& buffers, const Scene& scene, const ScreenTriangles& triangles) {
    const Size size = buffers.marks.size();
    Image<std::uint32_t> ids{size, 4};
    const auto patchAt = [&](int x, int y) {
        const std::uint32_t number = buffers.triangles(x, y);
        return number == 0 ? 0U : scene::patchOf(scene, triangles.locate(number - 1));
    };
    const raster::Rectangle part = aroundKept(buffers.tile);
    for (int y = part.y; y < part.y + part.size.height; ++y) {
        for (int x = part.x; x < part.x + part.size.width; ++x) {
            if (const std::uint32_t number = buffers.triangles(x, y); number != 0) {
                const scene::SceneFace t = triangles.locate(number - 1);
                const Instance& instance = scene.instances()[t.instance];
                const auto& materials = scene.meshes()[instance.mesh].materials;
                ids(x, y, 0) = scene::patchOf(scene, t);
                ids(x, y, 2) = t.instance + 1;
                ids(x, y, 3) = materials.empty() ? 0 : materials[t.triangle];
            }
            const unsigned marks = buffers.marks(x, y);
            const auto across = [&](int qx, int qy) {
                ids(x, y, 1) = patchAt(qx, qy);
                ids(qx, qy, 1) = patchAt(x, y);
            };
            if ((marks & 15U) != 0) across(x + 1, y);
            if ((marks >> 4U) != 0) across(x, y + 1);
        }
    }
    return ids;
}

}  // namespace inkedge::trace
