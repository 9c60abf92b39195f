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

/// How a face is seen. Front: its normal points towards the eye. EdgeOn: as a line, within MeshEdges::edgeOnSines;
/// rounding then says nothing about the side that is seen.
enum class Facing : std::uint8_t { Back = 0, Front = 1, EdgeOn = 2 };

/// The contour edges of a mesh for one eye.
struct FoundContours {
    std::vector<std::uint32_t> edges;  ///< into MeshEdges::shared, ascending
    std::vector<Facing> facing;        ///< one per face; empty unless every edge was looked at
};

/// What ContourFinder::Random remembers of the last view of an instance.
struct ContourMemory {
    std::vector<std::uint32_t> last;  ///< contour edges of the last view
    std::size_t sample = 0;           ///< index of the next sample
};

/// Finds the contour edges of one mesh: those between a front-facing and a back-facing face (Hertzmann 1999, section
/// 3.2). Those between a face that is seen edge-on and another face are contours too, if the edge is nearer to the eye
/// than the edge-on face is: the contour stays closed, along the near side of what is seen edge-on. Safe to use from
/// several threads, each with a memory of its own.
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

    /// How face t is seen. A face without a normal is Back.
    [[nodiscard]] Facing facing(const MeshEye& eye, std::uint32_t t) const {
        const glm::dvec3 view = eye.view(glm::dvec3{mesh_.positions[mesh_.indices[3 * std::size_t{t}]]});
        const double height = glm::dot(edges_.faceNormals[t], view);
        const double sine = double{edges_.edgeOnSines[t]};
        if (sine > 0.0 && height * height <= sine * sine * glm::dot(view, view)) return Facing::EdgeOn;
        return height < 0.0 ? Facing::Front : Facing::Back;
    }

    /// Whether face t, which is seen edge-on, lies before an edge of it: the face then hides the edge.
    [[nodiscard]] bool liesBefore(const MeshEye&, std::uint32_t t, std::uint32_t halfEdge) const;

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
        float largestSine = 0.0F;  // of MeshEdges::edgeOnSines
        double reach = 0.0;        // the distance of the farthest position from the mesh's origin
    };

    [[nodiscard]] std::vector<Facing> findFacing(const MeshEye&) const;
    [[nodiscard]] std::vector<std::uint32_t> findDiffering(const MeshEye&, const std::vector<Facing>& facing) const;
    [[nodiscard]] std::vector<std::uint32_t> searchAtRandom(const MeshEye&, ContourMemory&) const;
    [[nodiscard]] std::vector<std::uint32_t> searchMap(const MeshEye&) const;
    [[nodiscard]] const Samples& samples() const;
    [[nodiscard]] const GaussMap& map() const;
    [[nodiscard]] bool isContour(const MeshEye&, std::uint32_t edge) const;
    [[nodiscard]] bool isContour(const MeshEye&, std::uint32_t edge, Facing first, Facing second) const;

    const Mesh& mesh_;
    const mesh::MeshTopology& topology_;
    const MeshEdges& edges_;
    Planes planes_;
    mutable std::mutex mutex_;  // guards the data that are made on first use
    mutable std::unique_ptr<const Samples> samples_;
    mutable std::unique_ptr<const GaussMap> map_;
};

}  // namespace inkedge::lines
