#include "modules/open_module.h"
#include "mesh/subdivision.h"

namespace inkedge {

const Subdivision& subdivision() {
    constexpr Module module{.purpose = "subdivision",
                            .file = subdivisionFile,
                            .symbol = subdivisionSymbol,
                            .library = "OpenSubdiv",
                            .remedy = "leave subdivision out"};
    static const Subdivision& functions =
        *reinterpret_cast<decltype(&inkedge_subdivision_4)>(openModule(module, Error::Kind::Runtime))();
    return functions;
}

}  // namespace inkedge
