#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <inkedge/image.h>

#include "ink/brush.h"
#include "ink/stroke.h"
#include "ink/stroke_coverage.h"
#include "settings/pens.h"

namespace inkedge::ink {

/// Draws strokes with a brush. The strokes of a line are drawn together: where they meet a pixel takes the brush's ink
/// of the nearest stroke.
class BrushedStrokes {
public:
    /// @param strokes  must outlive it; those of a line follow each other
    /// @param rows     width and height of what cover() is called for
    BrushedStrokes(const Brush&, std::span<const Stroke> strokes, const std::array<settings::Pen, settings::penCount>&,
                   Size rows);

    /// Raises coverage to that of strokes, times the brush's ink.
    /// @param coverage  of the rows, 0 to 1
    /// @param shown     some of the strokes, in their order
    /// @param pens      the pens whose strokes are drawn
    void cover(Image<float>& coverage, Rows, std::span<const BoxedStroke> shown,
               const std::bitset<settings::penCount>& pens);

private:
    // How a stroke is connected to its line. Beyond an open end, that of the line or of a dash, the brush goes straight
    // on; around other ends it turns.
    struct InLine {
        std::uint32_t line;  // index of the line's first stroke
        bool opensFrom;
        bool opensTo;
        float around;  // length around a closed line, pixels; 0 for an open line
    };

    static std::vector<InLine> linesOf(std::span<const Stroke>);
    [[nodiscard]] const InLine& lineOf(const BoxedStroke& boxed) const {
        return inLine_[static_cast<std::size_t>(boxed.stroke - strokes_.data())];
    }
    void coverLine(Image<float>& coverage, Rows, std::span<const BoxedStroke>);
    void clear(PixelBox, Rows);
    void add(const BoxedStroke&, Rows);

    std::span<const Stroke> strokes_;
    std::vector<InLine> inLine_;                                          // one per stroke
    std::array<std::optional<FittedBrush>, settings::penCount> brushes_;  // of each pen that draws strokes

    // One line in the rows, before it is painted over the others.
    Image<float> coverage_;
    Image<float> distance_;  // to the line's nearest stroke, pixels
    Image<float> ink_;       // of that stroke
};

}  // namespace inkedge::ink
