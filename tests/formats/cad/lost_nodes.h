#pragma once

#include <inkedge/edge_kinds.h>

namespace inkedge::cad_files {

/// What an EdgeTable says of a meshed box, when OpenCASCADE has lost the nodes of one edge on one of its two faces:
/// they are 0 then, where they count from 1.
struct LostNodes {
    int borders = 0;     ///< edges of triangles that it takes for edges of the box; each counts on both faces
    EdgeKind onOther{};  ///< the kind of that edge on the other face
};
[[nodiscard]] LostNodes boxOfLostNodes();

}  // namespace inkedge::cad_files
