#pragma once

#include <gmock/gmock.h>

#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::framed_pictures {

inline Maps renderFramed(Renderer& renderer, const Scene& scene, Size size) {
    return renderer.render(scene, frameCamera(scene, {}, size), gl_test::classic(size, gl_test::classicMaps));
}

inline void expectSame(const Maps& a, const Maps& b) {
    EXPECT_EQ(a.picture, b.picture);
    EXPECT_EQ(a.depth, b.depth);
    EXPECT_EQ(a.windowDepth, b.windowDepth);
    EXPECT_EQ(a.normal, b.normal);
    EXPECT_EQ(a.depthMagnitude, b.depthMagnitude);
    EXPECT_EQ(a.normalMagnitude, b.normalMagnitude);
    EXPECT_EQ(a.depthEdges, b.depthEdges);
    EXPECT_EQ(a.normalEdges, b.normalEdges);
    EXPECT_EQ(a.edges, b.edges);
}

inline std::size_t differing(const Image<std::uint8_t>& a, const Image<std::uint8_t>& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.pixels().size(); ++i) count += a.pixels()[i] != b.pixels()[i] ? 1U : 0U;
    return count;
}

// An orthographic camera on +Z that sees the square -1..1.
inline Camera squareCamera() {
    Camera camera;
    camera.view = scenes::translation({0, 0, -5});
    camera.orthographicHeight = 2.0;
    camera.near = 1.0;
    camera.far = 9.0;
    return camera;
}

}  // namespace inkedge::framed_pictures
