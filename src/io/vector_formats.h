#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <inkedge/error.h>

#include "io/drawing.h"
#include "modules/open_module.h"

// The interface between the library and the module that draws by Cairo. Cairo brings 20 libraries, fonts and X11 among
// them.

namespace inkedge::io {

struct EncodedDocument {
    std::vector<std::uint8_t> bytes;
    std::string failure;
};

struct PaintedDrawing {
    Image<std::uint8_t> picture;  ///< RGB
    std::string failure;
};

/// The module's functions; safe to call from several threads.
struct VectorFormats {
    /// A drawing as a PDF of one page.
    EncodedDocument (*encodePdf)(const Drawing&);
    /// A drawing as a picture; where it has no background it is white.
    /// @param size  of the picture, of the page's shape
    PaintedDrawing (*paint)(const Drawing&, Size);
};

inline constexpr modules::ModuleOf<VectorFormats> vectorModule{{.purpose = "PDF files and pictures of sheets",
                                                                .file = "inkedge_vector_formats.so",
                                                                .symbol = "inkedge_vector_formats_1",
                                                                .library = "Cairo",
                                                                .option = "",
                                                                .remedy = "write .svg, which needs no module"}};

}  // namespace inkedge::io
