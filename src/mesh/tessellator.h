#pragma once

#include <span>
#include <string>
#include <vector>

#include "mesh/polygon_triangles.h"
#include "modules/open_module.h"

namespace inkedge {

// What the library and the module of the OpenGL Utility Library's tessellator say to each other. Linked to the library
// itself it would cost every start, and its gl functions would come before OSMesa's.
struct Tessellation {
    std::vector<Polygon> loops;
    std::string failure;
};
struct Tessellator {
    /// The border of what any of the loops goes around.
    Tessellation (*border)(std::span<const Polygon> loops);
    /// Triangles, as loops of three corners, that cover what both an area's loops and another go around.
    Tessellation (*overlap)(std::span<const Polygon> area, const Polygon& other);
};
inline constexpr ModuleOf<Tessellator> tessellatorModule{{.purpose = "outlines of cut-outs",
                                                          .file = "inkedge_tessellator.so",
                                                          .symbol = "inkedge_tessellator_1",
                                                          .library = "libGLU",
                                                          .option = "",
                                                          .remedy = "use --alpha-mask ignore"}};

}  // namespace inkedge
