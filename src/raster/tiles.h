#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <inkedge/image.h>
#include <inkedge/maps.h>

#include "raster/rectangle.h"

namespace inkedge::raster {

/// A part of a picture that is drawn at once. Lengths are samples (or pixels, see inPixels()) of the whole picture.
struct Tile {
    Tile() = default;
    /// The whole picture in one tile.
    Tile(Size picture) : whole{picture}, drawn{0, 0, picture}, kept{drawn} {}
    Tile(Size picture, Rectangle drawnPart, Rectangle keptPart) : whole{picture}, drawn{drawnPart}, kept{keptPart} {}

    Size whole;
    Rectangle drawn;  ///< kept and a margin around it, in which passes find the neighbours of kept samples
    Rectangle kept;   ///< the part that the tile gives to the picture; those of all tiles cover the picture once

    /// kept, counted from drawn's corner.
    [[nodiscard]] Rectangle keptInDrawn() const noexcept { return {kept.x - drawn.x, kept.y - drawn.y, kept.size}; }
};

/// Samples that are drawn around the kept part of a tile, except at the picture's edge: more than the reach of any
/// detector (Farid's kernels: 2; the filter of pinholes and the cells of the ink: 3). Every tile begins at a multiple
/// of it, so that drivers work on the same blocks of samples as for a picture in one piece.
inline constexpr int tileMargin = 64;

/// The tiles of a picture, row by row; one tile if no side is over maxSide. All draw parts of one size, so that one set
/// of buffers serves them.
/// @param maxSide  the largest side of what is drawn at once, at least 4 tileMargin; raised to 4 times the reach
/// @param reach    samples around the kept part of a tile that passes need; over 0
[[nodiscard]] std::vector<Tile> tilesOf(Size whole, int maxSide, int reach = tileMargin);

/// The same tile in pixels of so many samples along each axis. The tile's lengths are multiples of that number.
[[nodiscard]] Tile inPixels(const Tile&, int samplesPerPixel) noexcept;

/// The part of the picture that OpenGL's viewport shows while a tile is drawn. Along an axis of up to 16384 samples,
/// which every OpenGL 4.5 supports, that is the whole picture, so that triangles are clipped as for a picture in one
/// piece; else 16384 samples around the tile.
[[nodiscard]] Rectangle viewOf(const Tile&) noexcept;

/// Copies a part of an image to the rectangle `at` of another image with as many channels.
template <class T>
void paste(const Image<T>& from, const Rectangle& part, Image<T>& to, const Rectangle& at) {
    const auto values = static_cast<std::ptrdiff_t>(part.size.width) * from.channels();
    for (int y = 0; y < part.size.height; ++y) {
        std::copy_n(&from(part.x, part.y + y), values, &to(at.x, at.y + y));
    }
}

/// A part of an image.
template <class T>
[[nodiscard]] Image<T> cropped(Image<T> image, const Rectangle& part) {
    if (part == Rectangle{0, 0, image.size()}) return image;
    Image<T> result{part.size, image.channels()};
    paste(image, part, result, {0, 0, part.size});
    return result;
}

/// Copies the kept part of a tile's image to the picture's, which is made when the first tile comes.
/// @param part  of the size of Tile::drawn or of Tile::kept; empty: there is nothing to copy
template <class T>
void keep(Image<T> part, const Tile& tile, Image<T>& picture) {
    if (part.empty()) return;
    Rectangle from{0, 0, tile.kept.size};
    if (part.size() != tile.kept.size) from = tile.keptInDrawn();
    if (tile.kept.size == tile.whole) {
        picture = cropped(std::move(part), from);
        return;
    }
    if (picture.empty()) picture = Image<T>{tile.whole, part.channels()};
    paste(part, from, picture, tile.kept);
}

/// The same for a picture and its maps.
void keep(Maps part, const Tile&, Maps& picture);

}  // namespace inkedge::raster
