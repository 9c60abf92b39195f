#include <inkedge/error.h>

#include "mesh/subdivision.h"

namespace inkedge {

const Subdivision& subdivision() {
    throw Error{Error::Kind::Runtime,
                "subdivision: expected OpenSubdiv, found an inkedge that was built without it; build it with "
                "INKEDGE_OPENSUBDIV, or leave subdivision out"};
}

}  // namespace inkedge
