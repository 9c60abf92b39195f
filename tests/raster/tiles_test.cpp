#include "raster/tiles.h"

#include <cstdint>

#include <gtest/gtest.h>

namespace inkedge::raster {
namespace {

constexpr Size pictures[]{{1, 1},       {256, 256},   {257, 256},     {300, 1000},  {1000, 700},  {4096, 4096},
                          {4097, 5000}, {20000, 300}, {32768, 32768}, {131072, 64}, {7680, 4320}, {319, 131071}};
constexpr int sides[]{256, 300, 1000, 4096, 8192};

bool contains(const Rectangle& outer, const Rectangle& inner) {
    return inner.x >= outer.x && inner.y >= outer.y && inner.x + inner.size.width <= outer.x + outer.size.width &&
           inner.y + inner.size.height <= outer.y + outer.size.height;
}

// Calls check(picture, side, tiles) for every picture and side above.
template <class Check>
void forEach(Check check) {
    for (const Size picture : pictures) {
        for (const int side : sides) {
            SCOPED_TRACE(testing::Message() << picture.width << " x " << picture.height << " by " << side);
            check(picture, side, tilesOf(picture, side));
        }
    }
}

TEST(Tiles, ofASmallPictureAreOne) {
    const std::vector<Tile> tiles = tilesOf({4096, 17}, 4096);
    ASSERT_EQ(tiles.size(), 1);
    EXPECT_EQ(tiles[0].whole, (Size{4096, 17}));
    EXPECT_EQ(tiles[0].drawn, (Rectangle{0, 0, {4096, 17}}));
    EXPECT_EQ(tiles[0].kept, tiles[0].drawn);
}

TEST(Tiles, giveEveryPixelOnce) {
    forEach([](Size picture, int, const std::vector<Tile>& tiles) {
        std::int64_t pixels = 0;
        int x = 0;
        int y = 0;
        for (const Tile& tile : tiles) {  // row by row, each beside the last
            EXPECT_EQ(tile.kept.x, x);
            EXPECT_EQ(tile.kept.y, y);
            pixels += std::int64_t{tile.kept.size.width} * tile.kept.size.height;
            x += tile.kept.size.width;
            if (x != picture.width) continue;
            x = 0;
            y += tile.kept.size.height;
        }
        EXPECT_EQ(y, picture.height);
        EXPECT_EQ(pixels, std::int64_t{picture.width} * picture.height);
    });
}

TEST(Tiles, haveAMarginButAtThePicturesEdge) {
    forEach([](Size picture, int, const std::vector<Tile>& tiles) {
        for (const auto& [whole, drawn, kept] : tiles) {
            const int left = std::max(kept.x - tileMargin, 0);
            const int top = std::max(kept.y - tileMargin, 0);
            const int right = std::min(kept.x + kept.size.width + tileMargin, picture.width);
            const int bottom = std::min(kept.y + kept.size.height + tileMargin, picture.height);
            EXPECT_TRUE(contains(drawn, {left, top, {right - left, bottom - top}}));
            EXPECT_TRUE(contains({0, 0, picture}, drawn));
        }
    });
}

TEST(Tiles, areOfOneSizeWithinTheLimitAndBeginAtMultiplesOfTheMargin) {
    forEach([](Size, int side, const std::vector<Tile>& tiles) {
        for (const Tile& tile : tiles) {
            EXPECT_EQ(tile.drawn.size, tiles[0].drawn.size);
            EXPECT_LE(std::max(tile.drawn.size.width, tile.drawn.size.height), side);
            EXPECT_EQ(tile.drawn.x % tileMargin, 0);
            EXPECT_EQ(tile.drawn.y % tileMargin, 0);
        }
    });
}

TEST(Tiles, ofSamplesAreWholePixels) {
    for (const int samples : {2, 4}) {
        for (const Tile& tile : tilesOf({999 * samples, 1234 * samples}, 512)) {
            const Tile pixels = inPixels(tile, samples);
            EXPECT_EQ(pixels.whole, (Size{999, 1234}));
            for (const auto& [few, many] : {std::pair{pixels.kept, tile.kept}, {pixels.drawn, tile.drawn}}) {
                EXPECT_EQ((Rectangle{
                              few.x * samples, few.y * samples, {few.size.width * samples, few.size.height * samples}}),
                          many);
            }
        }
    }
}

TEST(Tiles, areDrawnWithinAViewportThatEveryOpenGlHas) {
    forEach([](Size picture, int, const std::vector<Tile>& tiles) {
        for (const Tile& tile : tiles) {
            const Rectangle view = viewOf(tile);
            EXPECT_TRUE(contains(view, tile.drawn));
            EXPECT_TRUE(contains({0, 0, picture}, view));
            EXPECT_EQ(view.size, (Size{std::min(picture.width, 16384), std::min(picture.height, 16384)}));
        }
    });
}

TEST(Tiles, putTogetherAreThePicture) {
    Image<std::uint16_t> picture{{700, 650}, 3};
    for (std::size_t i = 0; i < picture.pixels().size(); ++i)
        picture.mutablePixels()[i] = static_cast<std::uint16_t>(i * 31);
    Image<std::uint16_t> fromDrawn;
    Image<std::uint16_t> fromKept;
    for (const Tile& tile : tilesOf(picture.size(), 256)) {
        keep(cropped(picture, tile.drawn), tile, fromDrawn);
        keep(cropped(picture, tile.kept), tile, fromKept);
    }
    EXPECT_EQ(fromDrawn, picture);
    EXPECT_EQ(fromKept, picture);
}

}  // namespace
}  // namespace inkedge::raster
