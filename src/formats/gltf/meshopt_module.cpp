#include "formats/gltf/meshopt.h"

#include <meshoptimizer.h>

#include <inkedge/export.h>

namespace inkedge::gltf {

extern "C" INKEDGE_API const MeshoptFunctions* inkedge_meshopt_2() noexcept {
    static constexpr MeshoptFunctions functions{meshopt_decodeVertexBuffer,  meshopt_decodeIndexBuffer,
                                                meshopt_decodeIndexSequence, meshopt_decodeFilterOct,
                                                meshopt_decodeFilterQuat,    meshopt_decodeFilterExp};
    return &functions;
}

}  // namespace inkedge::gltf
