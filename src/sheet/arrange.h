#pragma once

#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>

#include <inkedge/sheet.h>

#include "sheet/rect.h"

namespace inkedge::sheet {

/// A view, and how wide and high the model is in it: millimetres of the model.
struct ViewExtent {
    NamedView view;
    glm::dvec2 size;
};

/// Where views may lie.
struct Space {
    Rect framed;
    Rect titleBlock;
    double gap;  ///< between views at least, and half of it to the frame and the title block; millimetres
};

struct Arrangement {
    double scale = 1.0;               ///< paper : model
    std::vector<glm::dvec2> middles;  ///< of the views, in their order; millimetres on the page
};

/// Whether a view looks at one of six sides.
[[nodiscard]] bool isPrincipal(NamedView) noexcept;

/// Arranges views as the projection has them: those of six sides in rows and columns, so that their middles are on
/// one line, the others in free cells of these or beside them, where the scale can be largest. No view overlaps another
/// or the title block.
/// @param scale  none: the largest of standardScales() that fits
/// @return  none: the scale does not fit
[[nodiscard]] std::optional<Arrangement> arranged(std::span<const ViewExtent>, Projection, const Space&,
                                                  std::optional<double> scale);

}  // namespace inkedge::sheet
