#pragma once

#include <cstdint>
#include <vector>

#include <inkedge/mesh.h>

#include "lines/find/face_tree.h"
#include "mesh/topology.h"

namespace inkedge::lines {

/// Which nodes of a tree hold triangles of one face of a CAD file alone, so that a search for triangles that cross can
/// skip those that cannot: a face of a shell does not cross itself, nor does it meet a face beside it but in their
/// edges (ISO 10303-42, face and connected_face_set).
class FileFaces {
public:
    /// O(n log n) for the edges between faces.
    FileFaces(const FaceTree&, const Mesh&, const mesh::MeshTopology&);

    /// Whether all triangles below two nodes are of one face, or of two that share an edge.
    /// @param level, index  of a node, as BoxLevels has it; of a packet 0 and its number
    [[nodiscard]] bool areBeside(std::uint32_t level, std::uint32_t index, std::uint32_t otherLevel,
                                 std::uint32_t otherIndex) const noexcept;

private:
    static constexpr std::uint32_t several = ~0U;

    void findNeighbours(const Mesh&, const mesh::MeshTopology&);

    std::vector<std::vector<std::uint32_t>> levels_;  // as BoxLevels has them: the face of each node; none: no faces
    std::vector<std::uint64_t> neighbours_;           // sorted pairs of faces that share an edge
};

/// Whether a mesh knows the faces of a CAD file.
[[nodiscard]] inline bool hasFileFaces(const Mesh& mesh) noexcept {
    return !mesh.faces.empty() && !mesh.parameters.empty();
}

}  // namespace inkedge::lines
