#include "passes/composite.h"

#include <gmock/gmock.h>

#include <inkedge/reference.h>

#include "gl/gl_test.h"
#include "gl/read_back.h"
#include "scenes.h"

namespace inkedge {
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

TEST_P(Composite, equalsItsDefinitionForEveryMark) {
    const gl::Current current{context()};
    const gl::Api& api = gpu().api;
    constexpr Size size{5, 3};
    // Any mark but 0 is a line, whichever of its bits are set.
    const std::vector<std::uint8_t> marks{0, 1, 2, 3, 0, 128, 255, 0, 1, 0, 0, 2, 0, 3, 1};
    const gl::Texture texture = gpu().textures.acquire(size, GL_R8UI);
    api.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
    api.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    api.TextureSubImage2D(texture.id(), 0, 0, 0, size.width, size.height, GL_RED_INTEGER, GL_UNSIGNED_BYTE,
                          marks.data());
    Image<std::uint8_t> edges{size, 1};
    std::ranges::transform(marks, edges.pixels.begin(),
                           [](std::uint8_t m) { return static_cast<std::uint8_t>(m != 0 ? 255 : 0); });
    for (const PictureSettings& settings : everyKind) {
        const Image<std::uint8_t> expected = reference::composite(edges, settings);
        const gl::Texture picture = composite(gpu(), texture, settings);
        EXPECT_EQ(picture.size(), size);
        EXPECT_EQ(picture.format(), static_cast<GLenum>(expected.channels == 1 ? GL_R8 : GL_RGBA8));
        EXPECT_EQ(gl::readBytes(api, picture, expected.channels).pixels, expected.pixels);
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
        EXPECT_EQ(maps.picture.size, expected.size);
        EXPECT_EQ(maps.picture.channels, expected.channels);
        EXPECT_EQ(maps.picture.pixels, expected.pixels);
        EXPECT_GT(std::ranges::count(maps.edges.pixels, 255), 50);
    }
}

}  // namespace
}  // namespace inkedge
