#include "raster/tiles.h"

namespace inkedge::raster {
namespace {

// A tile's extent along one axis.
struct Span {
    int drawn;
    int drawnLength;
    int kept;
    int keptLength;
};

constexpr int downTo(int multiple, int value) { return value / multiple * multiple; }

// Divides a length into spans of one length that begin at multiples of tileMargin. The last span ends where the picture
// ends: hence the length of a span leaves the same remainder as the picture's.
std::vector<Span> spansOf(int whole, int maxLength, int margin) {
    if (whole <= maxLength) return {{0, whole, 0, whole}};
    const int remainder = whole % tileMargin;
    int length = downTo(tileMargin, maxLength - remainder) + remainder;
    const auto stepOf = [&](int l) { return downTo(tileMargin, l) - 2 * margin; };
    const auto countOf = [&](int l) { return 1 + (whole - l + stepOf(l) - 1) / stepOf(l); };
    const int count = countOf(length);
    while (stepOf(length - tileMargin) > 0 && countOf(length - tileMargin) == count) length -= tileMargin;

    std::vector<Span> spans;
    for (int i = 0; i < count; ++i) {
        const int drawn = std::min(i * stepOf(length), whole - length);
        const int kept = i == 0 ? 0 : drawn + margin;
        if (i > 0) spans.back().keptLength = kept - spans.back().kept;
        spans.push_back({drawn, length, kept, whole - kept});
    }
    return spans;
}

// The largest viewport that every OpenGL 4.5 has: GL_MAX_VIEWPORT_DIMS is at least its GL_MAX_TEXTURE_SIZE.
constexpr int maxViewport = 16384;

// Where the viewport begins in the picture.
int viewportStart(int whole, int drawn, int drawnLength) {
    const int start = downTo(tileMargin, std::max(0, drawn + drawnLength / 2 - maxViewport / 2));
    return std::max(0, std::min(start, whole - maxViewport));
}

}  // namespace

std::vector<Tile> tilesOf(Size whole, int maxSide, int reach) {
    const int margin = (reach + tileMargin - 1) / tileMargin * tileMargin;
    const int maxLength = std::max(maxSide, 4 * margin);
    std::vector<Tile> tiles;
    const std::vector<Span> columns = spansOf(whole.width, maxLength, margin);
    for (const Span& y : spansOf(whole.height, maxLength, margin)) {
        for (const Span& x : columns) {
            tiles.push_back({whole,
                             {x.drawn, y.drawn, {x.drawnLength, y.drawnLength}},
                             {x.kept, y.kept, {x.keptLength, y.keptLength}}});
        }
    }
    return tiles;
}

Tile inPixels(const Tile& tile, int samplesPerPixel) noexcept {
    const auto size = [&](Size s) { return Size{s.width / samplesPerPixel, s.height / samplesPerPixel}; };
    const auto part = [&](const Rectangle& r) {
        return Rectangle{r.x / samplesPerPixel, r.y / samplesPerPixel, size(r.size)};
    };
    return {size(tile.whole), part(tile.drawn), part(tile.kept)};
}

Rectangle viewOf(const Tile& tile) noexcept {
    const auto& [whole, drawn, kept] = tile;
    return {viewportStart(whole.width, drawn.x, drawn.size.width),
            viewportStart(whole.height, drawn.y, drawn.size.height),
            {std::min(whole.width, maxViewport), std::min(whole.height, maxViewport)}};
}

void keep(Maps part, const Tile& tile, Maps& maps) {
    keep(std::move(part.picture), tile, maps.picture);
    keep(std::move(part.depth), tile, maps.depth);
    keep(std::move(part.windowDepth), tile, maps.windowDepth);
    keep(std::move(part.normal), tile, maps.normal);
    keep(std::move(part.depthMagnitude), tile, maps.depthMagnitude);
    keep(std::move(part.normalMagnitude), tile, maps.normalMagnitude);
    keep(std::move(part.depthEdges), tile, maps.depthEdges);
    keep(std::move(part.normalEdges), tile, maps.normalEdges);
    keep(std::move(part.edges), tile, maps.edges);
    keep(std::move(part.types), tile, maps.types);
    keep(std::move(part.ids), tile, maps.ids);
    keep(std::move(part.shade), tile, maps.shade);
}

}  // namespace inkedge::raster
