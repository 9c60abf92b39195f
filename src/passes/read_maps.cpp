#include "passes/read_maps.h"

#include <algorithm>

#include "gl/read_back.h"

namespace inkedge::passes {

Image<std::uint8_t> mask(const Image<std::uint16_t>& types, LineTypes wanted) {
    Image<std::uint8_t> edges{types.size(), 1};
    std::ranges::transform(types.pixels(), edges.mutablePixels().begin(), [bits = wanted.bits()](std::uint16_t t) {
        return static_cast<std::uint8_t>((t & bits) != 0 ? 255 : 0);
    });
    return edges;
}

void readSurface(const gl::Api& api, const SurfaceBuffers& buffers, SurfaceMaps wanted, Maps& maps) {
    if (wanted.depth) {
        maps.windowDepth = gl::readDepth(api, buffers.depth);
        for (float& z : maps.windowDepth.mutablePixels()) z = 1.0F - z;
    }
    if (!wanted.depth && !wanted.normal) return;
    const Image<float> surface = gl::readFloats(api, buffers.surface, 4);
    const std::size_t count = surface.pixels().size() / 4;
    if (wanted.depth) {
        maps.depth = Image<float>{surface.size(), 1};
        for (std::size_t i = 0; i < count; ++i) maps.depth.mutablePixels()[i] = surface.pixels()[4 * i + 3];
    }
    if (wanted.normal) {
        maps.normal = Image<float>{surface.size(), 3};
        for (std::size_t i = 0; i < count; ++i) {
            std::copy_n(surface.pixels().begin() + static_cast<std::ptrdiff_t>(4 * i), 3,
                        maps.normal.mutablePixels().begin() + static_cast<std::ptrdiff_t>(3 * i));
        }
    }
}

void readEdges(const gl::Api& api, const EdgeBuffers& buffers, EdgeMaps wanted, Maps& maps) {
    const auto [depth, normal, either] = wanted;
    if (!depth && !normal && !either) return;
    const EdgeMarks marks = readMarks(api, buffers);
    if (depth) maps.depthEdges = mask(marks, EdgeMarks::depthEdge);
    if (normal) maps.normalEdges = mask(marks, EdgeMarks::normalEdge);
    if (either) maps.edges = mask(marks, EdgeMarks::depthEdge | EdgeMarks::normalEdge);
    if (!buffers.magnitudes) return;
    const Image<float> magnitudes = gl::readFloats(api, *buffers.magnitudes, 2);
    if (depth) maps.depthMagnitude = Image<float>{magnitudes.size(), 1};
    if (normal) maps.normalMagnitude = Image<float>{magnitudes.size(), 1};
    for (std::size_t i = 0; i < magnitudes.pixels().size() / 2; ++i) {
        if (depth) maps.depthMagnitude.mutablePixels()[i] = magnitudes.pixels()[2 * i];
        if (normal) maps.normalMagnitude.mutablePixels()[i] = magnitudes.pixels()[2 * i + 1];
    }
}

}  // namespace inkedge::passes
