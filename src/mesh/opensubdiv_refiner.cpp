#include "mesh/opensubdiv_refiner.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <vector>

#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

namespace inkedge::mesh {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

// How many corners have values of their own; 0: there are only positions.
std::size_t cornersWithValues(const ControlMesh& control) {
    return std::max(control.coordinates.size(), control.paint.size());
}

}  // namespace

Refiner makeRefiner(const ControlMesh& control) {
    const std::vector<float> sharpEdges(control.sharpEdges.size() / 2, Sdc::Crease::SHARPNESS_INFINITE);
    const std::vector<float> sharpVertices(control.sharpVertices.size(), Sdc::Crease::SHARPNESS_INFINITE);
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(control.positions.size());
    descriptor.numFaces = static_cast<int>(control.faceSizes.size());
    descriptor.numVertsPerFace = control.faceSizes.data();
    descriptor.vertIndicesPerFace = control.corners.data();
    descriptor.numCreases = static_cast<int>(sharpEdges.size());
    descriptor.creaseVertexIndexPairs = control.sharpEdges.data();
    descriptor.creaseWeights = sharpEdges.data();
    descriptor.numCorners = static_cast<int>(sharpVertices.size());
    descriptor.cornerVertexIndices = control.sharpVertices.data();
    descriptor.cornerWeights = sharpVertices.data();

    // The index of each corner's values. An edge is no seam if both its ends have the same values in both its faces.
    std::vector<int> ofCorners(cornersWithValues(control));
    std::iota(ofCorners.begin(), ofCorners.end(), 0);
    Far::TopologyDescriptor::FVarChannel channel;
    channel.numValues = static_cast<int>(ofCorners.size());
    channel.valueIndices = ofCorners.data();
    descriptor.numFVarChannels = ofCorners.empty() ? 0 : 1;
    descriptor.fvarChannels = &channel;

    const bool loop = control.scheme == SubdivisionScheme::Loop;
    Sdc::Options options;
    options.SetFVarLinearInterpolation(Sdc::Options::FVAR_LINEAR_ALL);
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);  // corners are given
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    Refiner refiner{Factory::Create(descriptor, {loop ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK, options})};
    if (!refiner) throw std::runtime_error{"OpenSubdiv refuses the faces"};
    return refiner;
}

}  // namespace inkedge::mesh
