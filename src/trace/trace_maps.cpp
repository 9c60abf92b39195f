#include "trace/trace_maps.h"

#include <algorithm>

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

Image<std::uint16_t> typesOfPixels(const Image<std::uint16_t>& samples, int samplesPerPixel) {
    Image<std::uint16_t> types{{samples.size().width / samplesPerPixel, samples.size().height / samplesPerPixel}, 1};
    for (int y = 0; y < samples.size().height; ++y) {
        for (int x = 0; x < samples.size().width; ++x) types(x / samplesPerPixel, y / samplesPerPixel) |= samples(x, y);
    }
    return types;
}

Image<std::uint32_t> idsOfPixels(const Image<std::uint32_t>& samples, const Image<std::uint16_t>& types,
                                 int samplesPerPixel) {
    const Size size{samples.size().width / samplesPerPixel, samples.size().height / samplesPerPixel};
    Image<std::uint32_t> ids{size, samples.channels()};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            int fromX = x * samplesPerPixel + samplesPerPixel / 2;
            int fromY = y * samplesPerPixel + samplesPerPixel / 2;
            for (int i = samplesPerPixel * samplesPerPixel - 1; i >= 0; --i) {
                const int sampleX = x * samplesPerPixel + i % samplesPerPixel;
                const int sampleY = y * samplesPerPixel + i / samplesPerPixel;
                if (types(sampleX, sampleY) == 0 && samples(sampleX, sampleY, 1) == 0) continue;
                fromX = sampleX;
                fromY = sampleY;
            }
            std::copy_n(&samples(fromX, fromY), ids.channels(), &ids(x, y));
        }
    }
    return ids;
}

}  // namespace inkedge::trace
