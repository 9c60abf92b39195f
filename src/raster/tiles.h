#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include <inkedge/image.h>
#include <inkedge/maps.h>

#include "raster/rectangle.h"

namespace inkedge {

/// A part of a picture that is drawn at once. Lengths are samples (or pixels, see inPixels()) of the whole picture.
struct Tile {
    Tile() = default;
    /// The whole picture in one.
    Tile(Size picture) : whole{picture}, drawn{0, 0, picture}, kept{drawn} {}
    Tile(Size picture, Rectangle drawnPart, Rectangle keptPart) : whole{picture}, drawn{drawnPart}, kept{keptPart} {}

    Size whole;
    Rectangle drawn;  ///< kept and a margin around it, in which passes find their neighbours
    Rectangle kept;   ///< what the tile gives to the picture: those of all tiles cover it once

    /// kept, counted from drawn's corner.
    [[nodiscard]] Rectangle keptInDrawn() const noexcept { return {kept.x - drawn.x, kept.y - drawn.y, kept.size}; }
};

/// Samples around what a tile keeps, but at the picture's edge: more than the reach of any detector (Farid's kernels:
/// 2; the filter of pinholes and the cells of the ink: 3). Every tile begins at a multiple of it, so that drivers work
/// on the same blocks of samples as in one piece.
inline constexpr int tileMargin = 64;

/// The tiles of a picture, row by row; one if no side is over mostSide. All draw parts of one size, so that one set of
/// buffers serves them.
/// @param mostSide  of what is drawn at once, at least 4 tileMargin; but 4 times the reach, if that is more
/// @param reach     samples around what a tile keeps that passes need; over 0
[[nodiscard]] std::vector<Tile> tilesOf(Size whole, int mostSide, int reach = tileMargin);

/// The same tile counted in pixels of so many samples along each axis, which its lengths are multiples of.
[[nodiscard]] Tile inPixels(const Tile&, int samplesPerPixel) noexcept;

/// The part of the picture that OpenGL's viewport shows while a tile is drawn: all of it along an axis that is no
/// longer than 16384, which every OpenGL 4.5 can do, so that triangles are clipped as in one piece; else so much around
/// the tile.
[[nodiscard]] Rectangle viewOf(const Tile&) noexcept;

/// Copies a part of an image to where `at` lies in another, of as many channels.
template <class T>
void paste(const Image<T>& from, const Rectangle& part, Image<T>& to, const Rectangle& at) {
    const auto values = static_cast<std::ptrdiff_t>(part.size.width) * from.channels;
    for (int y = 0; y < part.size.height; ++y) {
        std::copy_n(&from.at(part.x, part.y + y), values, &to.at(at.x, at.y + y));
    }
}

/// A part of an image.
template <class T>
[[nodiscard]] Image<T> cropped(Image<T> image, const Rectangle& part) {
    if (part == Rectangle{0, 0, image.size}) return image;
    Image<T> result{part.size, image.channels};
    paste(image, part, result, {0, 0, part.size});
    return result;
}

/// Puts what a tile keeps of an image into the picture's, which is made when the first tile comes.
/// @param part  of the size of what is drawn, or of what is kept; empty: there is nothing to put
template <class T>
void keep(Image<T> part, const Tile& tile, Image<T>& picture) {
    if (part.empty()) return;
    Rectangle from{0, 0, tile.kept.size};
    if (part.size != tile.kept.size) from = tile.keptInDrawn();
    if (tile.kept.size == tile.whole) {
        picture = cropped(std::move(part), from);
        return;
    }
    if (picture.empty()) picture = Image<T>{tile.whole, part.channels};
    paste(part, from, picture, tile.kept);
}

/// The same of a picture and its maps.
void keep(Maps part, const Tile&, Maps& picture);

}  // namespace inkedge
