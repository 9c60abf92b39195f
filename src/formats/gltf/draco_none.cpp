// Stands in for gltf_draco.cpp where the build leaves libdraco out.
#include "base/message.h"
#include "formats/gltf/draco.h"

namespace inkedge::gltf {

bool readsDraco() noexcept { return false; }

DracoMesh decodeDraco(std::span<const std::uint8_t>, const DracoExpected&, std::uint64_t) {
    load::refuse("expected plain data, found KHR_draco_mesh_compression, which this build does not read");
}

}  // namespace inkedge::gltf
