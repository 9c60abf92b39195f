#include "mesh/connect.h"

#include <vector>

#include "mesh/authored_normals.h"
#include "mesh/creases.h"
#include "mesh/normals.h"

namespace inkedge::mesh {

MeshTopology connect(Mesh& mesh, const LoadSettings& settings) {
    keepUsableNormals(mesh, settings);
    MeshTopology topology = buildTopology(mesh);
    const std::vector<bool> disbelieved = mesh.surfaces ? std::vector<bool>{} : judgeNormals(mesh, topology, settings);
    findCreases(mesh, disbelieved, settings, topology);
    if (settings.completeNormals) completeNormals(mesh, topology, settings);
    buildPatches(settings.creaseAngle, topology);
    return topology;
}

}  // namespace inkedge::mesh
