#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/polygon_triangles.h"
#include "modules/open_module.h"

namespace inkedge::mesh {

// The interface between the library and the module of the OpenGL Utility Library's tessellator. If that were linked to
// the library, every start would be slower, and its gl functions would hide OSMesa's.
struct Tessellation {
    std::vector<Polygon> loops;
    std::string failure;
};
struct Tessellator {
    /// The border of the area that any of the loops encloses.
    Tessellation (*border)(std::span<const Polygon> loops);
    /// Triangles, as loops of three corners, that cover the part of an area that another loop encloses.
    Tessellation (*overlap)(std::span<const Polygon> area, const Polygon& other);
};
inline constexpr modules::ModuleOf<Tessellator> tessellatorModule{{.purpose = "outlines of cut-outs",
                                                                   .file = "inkedge_tessellator.so",
                                                                   .symbol = "inkedge_tessellator_1",
                                                                   .library = "libGLU",
                                                                   .option = "",
                                                                   .remedy = "use --alpha-mask ignore"}};

}  // namespace inkedge::mesh
