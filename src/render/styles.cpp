#include "render/styles.h"

#include <array>
#include <cstddef>

#include "passes/hatch.h"
#include "passes/ink_over.h"
#include "passes/pencil.h"
#include "passes/sumi.h"
#include "scene/typical_bend.h"

namespace inkedge::render {
namespace {

TileInk hatchInk(const Scene& scene, const RenderSettings& settings) {
    const double bend = settings.style.hatchBend ? *settings.style.hatchBend : scene::typicalBend(scene);
    return [&settings, bend](const TileFrames& tile, const Geometry& geometry) {
        const int samples = settings.picture.supersampling;
        return passes::meanOf(passes::hatch(tile.samples, geometry.planes->planes, settings.style, bend, samples),
                              samples);
    };
}

TileInk sumiInk(const Scene&, const RenderSettings& settings) {
    return [&settings](const TileFrames& tile, const Geometry& geometry) {
        return passes::sumi(tile.pixels, geometry.surface->surface, settings.style);
    };
}

Image<std::uint8_t> pencilRedraw(gl::Gpu& gpu, const Image<std::uint8_t>& drawing, const RenderSettings& settings) {
    return passes::pencil(gpu, drawing, settings.style, settings.picture.tileSize);
}

// In the order of Style.
const auto rows = std::to_array<StyleRow>({
    {.style = Style::Ink, .stage = "ink"},
    {.style = Style::Hatch, .stage = "hatch", .planes = true, .tileInk = hatchInk},
    {.style = Style::Sumi,
     .stage = "sumi",
     .drawsLines = false,
     .surface = true,
     .reach = passes::sumiReach,
     .tileInk = sumiInk},
    {.style = Style::Pencil, .stage = "pencil", .redraw = pencilRedraw},
    {.style = Style::None, .stage = "none", .drawsLines = false},
});

}  // namespace

const StyleRow& styleRow(Style style) { return rows.at(static_cast<std::size_t>(style)); }

}  // namespace inkedge::render
