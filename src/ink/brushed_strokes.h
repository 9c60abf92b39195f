#pragma once

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <inkedge/image.h>

#include "ink/brush.h"
#include "ink/pens.h"
#include "ink/stroke.h"
#include "ink/stroke_coverage.h"

namespace inkedge {

/// Draws strokes with a brush, each line's together: where a line's strokes meet, a pixel takes the brush's ink of the
/// one that is nearest to it.
class BrushedStrokes {
public:
    /// @param strokes  must outlive it; those of a line follow each other
    /// @param rows     width and height of what cover() is called for
    BrushedStrokes(const Brush&, std::span<const Stroke> strokes, const std::array<Pen, penCount>&, Size rows);

    /// Raises coverage to that of strokes, each pixel's times the brush's ink there.
    /// @param coverage  of the rows, 0 to 1
    /// @param shown     some of the strokes, in their order
    /// @param pens      those whose strokes are drawn
    void cover(Image<float>& coverage, Rows, std::span<const BoxedStroke> shown, const std::bitset<penCount>& pens);

private:
    // Which line a stroke is of, and whether its ends are that line's or a dash's, beyond which the brush goes straight
    // on; around the others it turns.
    struct InLine {
        std::uint32_t line;
        bool opensFrom;
        bool opensTo;
        float around;  // pixels of way around a closed line; of an open one 0
    };

    static std::vector<InLine> linesOf(std::span<const Stroke>);
    [[nodiscard]] const InLine& lineOf(const BoxedStroke& boxed) const {
        return inLine_[static_cast<std::size_t>(boxed.stroke - strokes_.data())];
    }
    void coverLine(Image<float>& coverage, Rows, std::span<const BoxedStroke>);
    void clear(PixelBox, Rows);
    void add(const BoxedStroke&, Rows);

    std::span<const Stroke> strokes_;
    std::vector<InLine> inLine_;                                // one a stroke
    std::array<std::optional<FittedBrush>, penCount> brushes_;  // one for each pen that draws strokes

    // One line in the rows, before it meets the others.
    Image<float> coverage_;
    Image<float> distance_;  // of its nearest stroke, pixels
    Image<float> ink_;       // that this stroke brings
};

}  // namespace inkedge
