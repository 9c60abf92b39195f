#include "scene/face_edges.h"

#include <cstddef>
#include <unordered_map>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "mesh/topology.h"
#include "scene/prepared.h"
#include "scene/seams.h"
#include "scene/world_triangles.h"

namespace inkedge::scene {
namespace {

glm::vec4 floatPlaneOf(const std::array<glm::dvec3, 3>& corners, double radius) {
    const glm::dvec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double length = glm::length(across);
    if (!(length > 0.0)) return glm::vec4{0.0F};
    const glm::dvec3 normal = across / length;
    return glm::vec4{glm::dvec4{normal, glm::dot(normal, corners[0]) / radius}};
}

void setFlag(FaceEdges& face, EdgeFlag flag, std::uint32_t k = 0) {
    face.flags |= static_cast<std::uint32_t>(flag) << k;
}

void connect(const mesh::MeshTopology& topology, std::uint32_t firstTriangle, std::uint32_t t, FaceEdges& face) {
    if (topology.originals[t] != t) return;  // it repeats another, which has the edges
    for (std::uint32_t k = 0; k < 3; ++k) {
        const std::uint32_t edge = 3 * t + k;
        const std::uint32_t twin = topology.twins[edge];
        if (mesh::isHalfEdge(twin)) {
            face.beyond[k] = firstTriangle + twin / 3;
            if (topology.creases[edge]) setFlag(face, EdgeFlag::Crease, k);
            if (topology.points[edge] == topology.points[twin]) setFlag(face, EdgeFlag::Reversed, k);
        } else if (twin == mesh::manyHalfEdges) {
            setFlag(face, EdgeFlag::Crease, k);
        } else if (topology.points[edge] != topology.points[mesh::nextHalfEdge(edge)]) {
            setFlag(face, EdgeFlag::Border, k);
        }
    }
}

// The halves of a border that another one covers.
class Seams {
public:
    Seams(const Scene& scene, const std::vector<std::uint32_t>& firstTriangles, std::vector<FaceEdges>& faces)
        : scene_{scene}, firstTriangles_{firstTriangles}, faces_{faces} {}

    void join() {
        std::unordered_map<std::uint32_t, std::vector<glm::dvec3>> normals;
        Borders borders{instancedMeshesOf(scene_), [&](std::uint32_t mesh) -> const std::vector<glm::dvec3>& {
                            const auto [entry, isNew] = normals.try_emplace(mesh);
                            if (isNew)
                                entry->second = mesh::makeFaceNormals(scene_.meshes()[mesh], topologyOf(scene_, mesh));
                            return entry->second;
                        }};
        const std::vector<BorderEdge>& edges = borders.edges();
        for (std::uint32_t i = 0; i < edges.size(); ++i) {
            borders.forEachNear(i, [&](std::uint32_t j) {
                const auto shared = runAlong(edges[i], edges[j], borders.tolerance());
                if (!shared) return;
                if (shared->to[0] - shared->from[0] > 0.5) put(edges[i], edges[j]);
                if (shared->to[1] - shared->from[1] > 0.5) put(edges[j], edges[i]);
            });
        }
    }

private:
    void put(const BorderEdge& edge, const BorderEdge& beyond) {
        FaceEdges& face = faces_[firstTriangles_[edge.instance] + edge.halfEdge / 3];
        const std::uint32_t k = edge.halfEdge % 3;
        if (!face.has(EdgeFlag::Border, k)) return;  // it has a face beyond already
        face.flags &= ~(static_cast<std::uint32_t>(EdgeFlag::Border) << k);
        face.beyond[k] = firstTriangles_[beyond.instance] + beyond.halfEdge / 3;
        if (glm::dot(edge.b - edge.a, beyond.b - beyond.a) > 0.0) setFlag(face, EdgeFlag::Reversed, k);
        const bool goesOn = patchOf(scene_, {edge.instance, edge.halfEdge / 3}) ==
                            patchOf(scene_, {beyond.instance, beyond.halfEdge / 3});
        if (!goesOn) setFlag(face, EdgeFlag::Crease, k);
    }

    const Scene& scene_;
    const std::vector<std::uint32_t>& firstTriangles_;
    std::vector<FaceEdges>& faces_;
};

}  // namespace

std::vector<FaceEdges> faceEdgesOf(const Scene& scene) {
    std::vector<FaceEdges> faces;
    std::vector<std::uint32_t> firstTriangles;
    const double radius = scene.bounds().radius > 0.0 ? scene.bounds().radius : 1.0;
    for (const Instance& instance : scene.instances()) {
        const auto first = static_cast<std::uint32_t>(faces.size());
        firstTriangles.push_back(first);
        const WorldTriangles triangles{scene, instance, scene.bounds().centre};
        const mesh::MeshTopology& topology = topologyOf(scene, instance.mesh);
        const bool mirrored = glm::determinant(glm::dmat3{instance.transform}) < 0.0;
        for (std::uint32_t t = 0; t < triangles.count(); ++t) {
            FaceEdges& face = faces.emplace_back();
            face.plane = floatPlaneOf(triangles.triangle(t), radius);
            if (mirrored) setFlag(face, EdgeFlag::Mirrored);
            if (t < oneSidedTriangles(scene, instance.mesh)) setFlag(face, EdgeFlag::OneSided);
            connect(topology, first, t, face);
        }
    }
    Seams{scene, firstTriangles, faces}.join();
    return faces;
}

}  // namespace inkedge::scene
