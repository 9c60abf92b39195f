#pragma once

#include <cstdint>
#include <unordered_set>
#include <vector>

#include <inkedge/mesh.h>

#include "lines/find/contours.h"
#include "lines/find/instance_view.h"
#include "lines/find/mesh_edges.h"
#include "lines/screen.h"
#include "lines/segment.h"
#include "mesh/topology.h"

namespace inkedge::lines {

/// Where smooth contours of an instance are looked for.
struct SmoothContourSearch {
    std::uint32_t instance;
    const Mesh& mesh;
    const mesh::MeshTopology& topology;
    const MeshEdges& edges;
    const Screen& screen;
    const CurveChoice& choice;
    const InstanceView& view;
    const std::vector<bool>& smooth;                 ///< one per patch: whether its contours are smooth
    const std::unordered_set<std::uint32_t>& large;  ///< triangles whose contours are mesh contours all the same
};

/// The smooth contours of collectInstanceCurves().
void addSmoothContours(const SmoothContourSearch&, std::vector<Segment>& to);

/// The smooth surfaces whose contours are looked for. Null: those of normals across triangles are.
[[nodiscard]] const FaceSurfaces* surfacesOf(const Mesh&, const CurveChoice&);

[[nodiscard]] double longestEdge(const Mesh&, std::uint32_t triangle);

}  // namespace inkedge::lines
