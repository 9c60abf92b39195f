#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include <glm/geometric.hpp>

#include <inkedge/scene.h>
#include <inkedge/settings.h>

#include "lines/find/gauss_map.h"
#include "lines/find/mesh_edges.h"

namespace inkedge::lines {

/// The eye in mesh space less Mesh::origin. There a mirroring transform does not matter for which side is seen.
struct MeshEye {
    bool orthographic = false;
    glm::dvec3 position{0.0};   ///< perspective
    glm::dvec3 direction{0.0};  ///< into the scene, of any length; orthographic

    /// The vector from the eye to a point: x - C.
    [[nodiscard]] glm::dvec3 view(glm::dvec3 p) const noexcept { return orthographic ? direction : p - position; }
};

/// The contour edges of a mesh for one eye.
struct FoundContours {
    std::vector<std::uint32_t> edges;  ///< into MeshEdges::shared, ascending
    std::vector<std::uint8_t> facing;  ///< one per face: 1 if it is front-facing; empty unless every edge was looked at
};

/// What ContourFinder::Random remembers of the last view of an instance.
struct ContourMemory {
    std::vector<std::uint32_t> last;  ///< contour edges of the last view
    std::size_t sample = 0;           ///< index of the next sample
};

/// Finds the contour edges of one mesh: those between a front-facing and a back-facing face (Hertzmann 1999, section
/// 3.2). Safe to use from several threads, each with a memory of its own.
class ContourSearch {
public:
    /// @param edges  of the mesh; all three must outlive this
    ContourSearch(const Mesh&, const mesh::MeshTopology&, const MeshEdges& edges);
    ~ContourSearch();

    [[nodiscard]] const MeshEdges& edges() const noexcept { return edges_; }

    /// Every: computes a byte per face that says which way it faces, and an exclusive or per edge. O(n).
    ///
    /// Gauss: takes the edges that GaussMap finds near the great circle of the view; the result is that of Every.
    /// Orthographic views only. The map is made for the first such view.
    ///
    /// Random: the randomized search of Markosian et al. 1997. It tests some edges, with a probability that grows with
    /// their bend, and those of the last view or, where these are no contours any more, edges beside them towards the
    /// contour. Each contour that it finds is followed over its end points. Contours that no test hits are missed, most
    /// likely small ones. About O(sqrt(n)); meshes of few edges are searched whole. The result depends on the mesh, the
    /// eye and the memory only.
    /// @throws Error  (Kind::Usage) for Gauss with a perspective eye
    [[nodiscard]] FoundContours find(const MeshEye&, ContourFinder, ContourMemory&) const;

    /// Whether face t is front-facing: its normal points towards the eye. A face without a normal is not.
    [[nodiscard]] bool isFront(const MeshEye& eye, std::uint32_t t) const {
        const glm::dvec3 corner{mesh_.positions[mesh_.indices[3 * std::size_t{t}]]};
        return glm::dot(edges_.faceNormals[t], eye.view(corner)) < 0.0;
    }

    /// Makes the data of a finder now rather than for its first view.
    /// @return  the bytes that the data take, without the edge table
    std::size_t prepare(ContourFinder) const;

private:
    struct Samples;
    class Walk;

    // The planes of the faces as floats, one array per component. They decide which way a face faces, unless rounding
    // leaves a doubt.
    struct Planes {
        std::vector<float> x, y, z, offset;
        float largestOffset = 0.0F;
    };

    [[nodiscard]] std::vector<std::uint8_t> findFacing(const MeshEye&) const;
    [[nodiscard]] std::vector<std::uint32_t> findDiffering(const std::vector<std::uint8_t>& facing) const;
    [[nodiscard]] std::vector<std::uint32_t> searchAtRandom(const MeshEye&, ContourMemory&) const;
    [[nodiscard]] std::vector<std::uint32_t> searchMap(const MeshEye&) const;
    [[nodiscard]] const Samples& samples() const;
    [[nodiscard]] const GaussMap& map() const;
    [[nodiscard]] bool isContour(const MeshEye&, std::uint32_t edge) const;

    const Mesh& mesh_;
    const mesh::MeshTopology& topology_;
    const MeshEdges& edges_;
    Planes planes_;
    mutable std::mutex mutex_;  // guards the data that are made on first use
    mutable std::unique_ptr<const Samples> samples_;
    mutable std::unique_ptr<const GaussMap> map_;
};

}  // namespace inkedge::lines
