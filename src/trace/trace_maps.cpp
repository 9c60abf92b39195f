#include "trace/trace_maps.h"

#include <algorithm>
#include <array>

#include "scene/prepared.h"

namespace inkedge::trace {

namespace {

constexpr int idsOfPixel = 4;  // the patch, the patch across, the node, the material
constexpr int patch = 0;
constexpr int across = 1;

// The ids of triangles by their numbers. Samples beside each other mostly show the same one.
class TriangleIds {
public:
    TriangleIds(const Scene& scene, const ScreenTriangles& triangles) : scene_{scene}, triangles_{triangles} {}

    const std::array<std::uint32_t, idsOfPixel>& of(std::uint32_t number) {
        if (number != number_) {
            const scene::SceneFace face = triangles_.locate(number - 1);
            const auto& materials = scene_.meshes()[scene_.instances()[face.instance].mesh].materials;
            ids_ = {scene::patchOf(scene_, face), 0, face.instance + 1,
                    materials.empty() ? 0 : materials[face.triangle]};
            number_ = number;
        }
        return ids_;
    }

private:
    const Scene& scene_;
    const ScreenTriangles& triangles_;
    std::uint32_t number_ = 0;
    std::array<std::uint32_t, idsOfPixel> ids_{};  // of 0: none
};

}  // namespace

Image<std::uint32_t> traceIds(const LineBuffers& buffers, const Scene& scene, const ScreenTriangles& triangles) {
    const auto [left, top, size] = aroundKept(buffers.tile);
    Image<std::uint32_t> ids{buffers.marks.size(), idsOfPixel};
    TriangleIds known{scene, triangles};
    for (int y = top; y < top + size.height; ++y) {
        for (int x = left; x < left + size.width; ++x) {
            if (const std::uint32_t number = buffers.triangles(x, y); number != 0)
                std::ranges::copy(known.of(number), &ids(x, y));
        }
    }
    for (int y = top; y < top + size.height; ++y) {
        forEachMarked(buffers.marks, y, left, left + size.width, [&](int x) {
            const unsigned marks = buffers.marks(x, y);
            const auto setAcross = [&](int qx, int qy) {
                ids(x, y, across) = ids(qx, qy, patch);
                ids(qx, qy, across) = ids(x, y, patch);
            };
            if ((marks & 15U) != 0) setAcross(x + 1, y);
            if ((marks >> 4U) != 0) setAcross(x, y + 1);
        });
    }
    return ids;
}

}  // namespace inkedge::trace
