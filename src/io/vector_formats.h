#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <inkedge/error.h>

#include "io/drawing.h"
#include "modules/open_module.h"

// The interface between the library and the module that writes PDF. Cairo brings 20 libraries, fonts and X11 among them.

namespace inkedge::io {

struct EncodedDocument {
    std::vector<std::uint8_t> bytes;
    std::string failure;
};

/// The module's functions; safe to call from several threads.
struct VectorFormats {
    /// A drawing as a PDF of one page.
    EncodedDocument (*encodePdf)(const Drawing&);
};

inline constexpr modules::ModuleOf<VectorFormats> vectorModule{{.purpose = "PDF files",
                                                                .file = "inkedge_vector_formats.so",
                                                                .symbol = "inkedge_vector_formats_1",
                                                                .library = "Cairo",
                                                                .option = "",
                                                                .remedy = "write .svg, which needs no module"}};

}  // namespace inkedge::io
