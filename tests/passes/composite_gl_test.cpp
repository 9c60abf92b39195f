#include "passes/composite.h"

#include <algorithm>
#include <random>

#include <gmock/gmock.h>

#include "reference/reference.h"

#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::passes {
namespace {

using gl_test::classic;

INKEDGE_ON_EACH_BACKEND(Composite);

PictureSettings colors(Color line, std::optional<Color> background) {
    PictureSettings settings;
    settings.lineColor = line;
    settings.background = background;
    return settings;
}

const std::vector<PictureSettings> everyKind{
    colors({0, 0, 0}, Color{255, 255, 255}),  // grey
    colors({200, 200, 200}, Color{17, 17, 17}),
    colors({255, 0, 0}, Color{255, 255, 255}),  // a colour in front
    colors({0, 0, 0}, Color{31, 78, 140}),      // a colour behind
    colors({1, 2, 3}, Color{254, 128, 127}),
    colors({0, 0, 0}, {}),  // nothing behind
    colors({12, 200, 99}, {}),
};

// Each pixel's marks packed as the shader packs them; where a block reaches over the border, stray bits.
EdgeMarks packed(const Image<std::uint8_t>& marks) {
    constexpr int side = EdgeMarks::blockSide;
    EdgeMarks result{marks.size(), {blocksOf(marks.size()), 1, 0}};
    for (int y = 0; y < side * result.blocks.size().height; ++y) {
        for (int x = 0; x < side * result.blocks.size().width; ++x) {
            const bool inside = x < marks.size().width && y < marks.size().height;
            const unsigned mark = inside ? marks.at(x, y) : 3U;
            result.blocks.at(x / side, y / side) |= mark << (2 * (y % side * side + x % side));
        }
    }
    return result;
}

TEST(CompositeOfMarks, equalsItsDefinitionForEveryMark) {
    std::mt19937 random{1};
    for (const Size size : {Size{1, 1}, Size{3, 5}, Size{4, 4}, Size{5, 3}, Size{8, 2}, Size{17, 33}, Size{250, 131}}) {
        Image<std::uint8_t> marks{size, 1};
        for (std::uint8_t& m : marks.mutablePixels()) m = static_cast<std::uint8_t>(random() % 4);
        Image<std::uint8_t> edges{size, 1};
        std::ranges::transform(marks.pixels(), edges.mutablePixels().begin(),
                               [](std::uint8_t m) { return static_cast<std::uint8_t>(m != 0 ? 255 : 0); });
        for (const PictureSettings& settings : everyKind) {
            const Image<std::uint8_t> expected = reference::composite(edges, settings);
            const Image<std::uint8_t> picture = composite(packed(marks), settings);
            EXPECT_EQ(picture.size(), size);
            EXPECT_EQ(picture.channels(), expected.channels());
            EXPECT_EQ(picture, expected);
        }
    }
}

TEST_P(Composite, makesTheRenderersPicture) {
    const Scene scene = scenes::sceneOf(scenes::cube());
    Settings settings = classic({50, 37}, {Map::Edges});  // no multiple of 4: rows are not padded
    const Camera camera = frameCamera(scene, {}, settings.picture.size);
    for (const PictureSettings& kind : everyKind) {
        settings.picture.lineColor = kind.lineColor;
        settings.picture.background = kind.background;
        const Maps maps = renderer().render(scene, camera, settings);
        const Image<std::uint8_t> expected = reference::composite(maps.edges, settings.picture);
        EXPECT_EQ(maps.picture.size(), expected.size());
        EXPECT_EQ(maps.picture.channels(), expected.channels());
        EXPECT_EQ(maps.picture, expected);
        EXPECT_GT(std::ranges::count(maps.edges.pixels(), 255), 50);
    }
}

}  // namespace
}  // namespace inkedge::passes
