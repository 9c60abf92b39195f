#pragma once

#include <inkedge/image.h>

namespace inkedge::raster {

/// A part of an image; (x, y) is its top left corner.
struct Rectangle {
    int x = 0;
    int y = 0;
    Size size;
    friend bool operator==(const Rectangle&, const Rectangle&) = default;
};

}  // namespace inkedge::raster
