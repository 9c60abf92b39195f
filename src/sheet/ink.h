#pragma once

#include <string>
#include <string_view>

#include "io/drawing.h"
#include "sheet/letters.h"
#include "sheet/rect.h"

namespace inkedge::sheet {

/// Pixels of a sheet's drawing in a millimetre.
inline constexpr double pixelsPerMillimetre = 10.0;

/// Lines and letters on the page beside the views, in millimetres, as a layer.
class Ink {
public:
    /// @param width  of the most lines
    Ink(std::string_view name, double width) {
        layer_.name = name;
        layer_.classes = name;
        layer_.width = width * pixelsPerMillimetre;
    }

    void line(glm::dvec2 from, glm::dvec2 to, double width) {
        io::Path& path = pathOf(width);
        path.moveTo(pixelsPerMillimetre * from);
        path.lineTo(pixelsPerMillimetre * to);
    }

    void rectangle(const Rect& rect, double width) {
        io::Path& path = pathOf(width);
        path.moveTo(pixelsPerMillimetre * rect.low);
        path.lineTo(pixelsPerMillimetre * glm::dvec2{rect.high.x, rect.low.y});
        path.lineTo(pixelsPerMillimetre * rect.high);
        path.lineTo(pixelsPerMillimetre * glm::dvec2{rect.low.x, rect.high.y});
        path.close();
    }

    void circle(glm::dvec2 middle, double radius, double width) {
        io::Path& path = pathOf(width);
        const glm::dvec2 across{radius, 0.0};
        path.moveTo(pixelsPerMillimetre * (middle - across));
        path.arcTo(pixelsPerMillimetre * radius, pixelsPerMillimetre * (middle + across));
        path.arcTo(pixelsPerMillimetre * radius, pixelsPerMillimetre * (middle - across));
        path.close();
    }

    /// @param at  the left end of the line that the letters stand on
    void text(std::string_view text, glm::dvec2 at, double height) {
        write(pathOf(lineWidthOf(height)), text, pixelsPerMillimetre * at, pixelsPerMillimetre * height);
    }

    /// The same around a point.
    void textAround(std::string_view words, glm::dvec2 middle, double height) {
        text(words, middle + glm::dvec2{-0.5 * widthOf(words, height), 0.5 * height}, height);
    }

    [[nodiscard]] io::Layer take() && { return std::move(layer_); }

private:
    io::Path& pathOf(double width) {
        const double pixels = width * pixelsPerMillimetre;
        for (io::DrawnPath& drawn : layer_.paths)
            if (drawn.width == pixels) return drawn.path;
        layer_.paths.push_back({{}, pixels, {}});
        return layer_.paths.back().path;
    }

    io::Layer layer_{};
};

}  // namespace inkedge::sheet
