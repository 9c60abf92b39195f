#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include <inkedge/image.h>
#include <inkedge/settings.h>

namespace inkedge::io {

/// What a document of vectors is drawn on. Lengths are pixels of the picture, which fall on halves where a size in
/// millimetres is no whole number of them.
struct Page {
    glm::dvec2 size{0.0};
    glm::dvec2 picture{0.0};        ///< where the picture's top left corner lies
    double dpi = 0.0;               ///< of the picture on it
    std::optional<PageSize> paper;  ///< the page's size; none: the document has no size on paper
};

/// The page, in whose middle the picture lies, as large as its shape allows or, if its size is given in millimetres or
/// by a scale, in that size; without --page-size the picture alone, on paper if the settings ask for anything in
/// millimetres.
[[nodiscard]] Page pageOf(const Settings&, Size picture);

}  // namespace inkedge::io
