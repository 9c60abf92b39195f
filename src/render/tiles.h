#pragma once

#include <vector>

#include <inkedge/maps.h>
#include <inkedge/settings.h>

#include "gl/function_inputs.h"
#include "gl/stage_clock.h"
#include "passes/frame.h"
#include "render/plan.h"

namespace inkedge::render {

/// What is found in the pixels of a picture.
struct Tiles {
    Maps maps;  ///< those of the plan; the picture, if its lines are those of the classic detector
    std::vector<trace::TracedPiece> pieces;  ///< of lines between planes
    Image<std::uint8_t> ink;  ///< how much of each pixel is covered besides lines, 0 to 255; empty: nothing
};

/// Draws the scene tile by tile. Strokes reach over the borders of tiles: they are painted when all are there.
/// @param picture  the frame of the whole picture, in samples
/// @throws Error   (Kind::Input, Kind::Runtime) as the passes do
[[nodiscard]] Tiles drawTiles(const passes::Frame& picture, gl::FunctionInputs&, const RenderSettings&, const Plan&,
                              gl::StageClock&);

}  // namespace inkedge::render
