// Stands in for gltf_meshopt.cpp where the build leaves libmeshoptimizer out.
#include "base/message.h"
#include "formats/gltf/meshopt.h"

namespace inkedge::gltf {

bool readsMeshopt() noexcept { return false; }

std::vector<std::uint8_t> decodeMeshopt(const MeshoptView&, std::span<const std::uint8_t>, std::uint64_t) {
    load::refuse("expected plain data, found EXT_meshopt_compression, which this build does not read");
}

}  // namespace inkedge::gltf
