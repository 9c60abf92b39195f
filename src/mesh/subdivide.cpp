#include "mesh/subdivide.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <inkedge/error.h>

#include "base/message.h"
#include "mesh/connect.h"
#include "mesh/limit_surfaces.h"
#include "mesh/subdivision.h"
#include "mesh/topology.h"

namespace inkedge::mesh {
namespace {

RefinedFaces refine(const ControlMesh& control, const std::string& name, int levels) {
    RefinedFaces faces = modules::functionsOf<subdivisionModule>(Error::Kind::Runtime).refine(control, levels);
    if (!faces.failure.empty())
        throw Error{Error::Kind::Runtime, fmt::format("mesh {}: expected faces that can be subdivided, found: {}",
                                                      base::quote(name), faces.failure)};
    return faces;
}

// The corners of the triangles that a face is cut into, by their index in the face. A quad is cut from its first
// corner.
constexpr std::array<std::size_t, 6> triangleCorners{0, 1, 2, 0, 2, 3};
constexpr std::size_t cutAfter = 2;   // index in triangleCorners: the edge from this corner to the next cuts the quad
constexpr std::size_t cutBefore = 3;  // the same for the other triangle

std::size_t cornersOf(SubdivisionScheme scheme) { return scheme == SubdivisionScheme::Loop ? 3 : 4; }

// The values in which corners of one vertex may differ.
struct CornerValues {
    glm::vec2 coordinates{0.0F};
    VertexPaint paint;
    [[nodiscard]] std::array<float, 8> numbers() const {
        return {coordinates.x, coordinates.y, paint.color.r, paint.color.g,
                paint.color.b, paint.color.a, paint.uv.x,    paint.uv.y};
    }
};

// Splits a vertex into several where its corners differ.
// @param ofIndices  one per index
void setCornerValues(Mesh& mesh, const std::vector<CornerValues>& ofIndices, const RefinedFaces& faces) {
    std::vector<std::uint32_t> order(mesh.indices.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [&](std::uint32_t c) { return std::pair{mesh.indices[c], ofIndices[c].numbers()}; };
    std::ranges::sort(order, {}, key);
    Mesh split;
    std::vector<std::uint32_t> indices(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const std::uint32_t c = order[i];
        if (i == 0 || key(c) != key(order[i - 1])) {
            split.positions.push_back(mesh.positions[mesh.indices[c]]);
            split.normals.push_back(mesh.normals[mesh.indices[c]]);
            if (!faces.coordinates.empty()) split.textureCoordinates.push_back(ofIndices[c].coordinates);
            if (!faces.paint.empty()) split.paint.push_back(ofIndices[c].paint);
        }
        indices[c] = static_cast<std::uint32_t>(split.positions.size() - 1);
    }
    mesh.positions = std::move(split.positions);
    mesh.normals = std::move(split.normals);
    mesh.textureCoordinates = std::move(split.textureCoordinates);
    mesh.paint = std::move(split.paint);
    mesh.indices = std::move(indices);
}

// The kinds of the edge from a corner to the next of its face. Refinement decides which edges are sharp.
EdgeKinds kindsOfEdge(const RefinedFaces& faces, std::size_t corner) {
    EdgeKinds kinds = faces.edges.empty() ? EdgeKinds{} : faces.edges[corner] - (EdgeKind::Inner | EdgeKind::Sharp);
    if (faces.creases[corner]) kinds |= EdgeKind::Sharp;
    return kinds;
}

Mesh trianglesOf(const RefinedFaces& faces, SubdivisionScheme scheme) {
    Mesh mesh;
    mesh.positions.assign(faces.positions.begin(), faces.positions.end());
    mesh.normals.assign(faces.normals.begin(), faces.normals.end());
    std::vector<CornerValues> values;
    const bool hasValues = !faces.coordinates.empty() || !faces.paint.empty();
    const std::size_t size = cornersOf(scheme);
    for (std::size_t f = 0; f < faces.parents.size(); ++f) {
        for (std::size_t i = 0; i < 3 * (size - 2); ++i) {
            const std::size_t corner = size * f + triangleCorners[i];
            const bool inner = size == 4 && (i == cutAfter || i == cutBefore);
            mesh.indices.push_back(faces.corners[corner]);
            mesh.edges.push_back(inner ? EdgeKind::Inner : kindsOfEdge(faces, corner));
            if (!hasValues) continue;
            CornerValues& value = values.emplace_back();
            if (!faces.coordinates.empty()) value.coordinates = faces.coordinates[corner];
            if (!faces.paint.empty()) value.paint = faces.paint[corner];
        }
    }
    if (std::ranges::all_of(mesh.edges, &EdgeKinds::empty)) mesh.edges.clear();
    if (hasValues) setCornerValues(mesh, values, faces);
    return mesh;
}

ControlMesh controlMeshOf(Mesh& mesh, const LoadSettings& settings) {
    const MeshTopology topology = connect(mesh, settings);
    return controlMesh(mesh, topology);
}

Mesh subdivided(const Mesh& mesh, ControlMesh control, int levels) {
    const RefinedFaces faces = refine(control, mesh.name, levels);
    Mesh result = trianglesOf(faces, control.scheme);
    result.name = mesh.name;
    result.origin = mesh.origin;
    result.lines = mesh.lines;
    const std::size_t trianglesPerFace = cornersOf(control.scheme) - 2;
    const auto ofTriangles = [&](const std::vector<std::uint32_t>& before, std::vector<std::uint32_t>& after) {
        if (before.empty()) return;
        for (const std::uint32_t parent : faces.parents)
            after.insert(after.end(), trianglesPerFace, before[control.firstTriangles[parent]]);
    };
    ofTriangles(mesh.materials, result.materials);
    ofTriangles(mesh.faces, result.faces);
    result.limitTriangles.resize(result.indices.size() / 3);
    std::iota(result.limitTriangles.begin(), result.limitTriangles.end(), 0U);
    result.surfaces = std::make_shared<const LimitSurfaces>(std::move(control), levels, mesh.origin);
    return result;
}

/// Bits: whether a part is seen from its front or at right angles, and whether a part is seen from its back.
using Signs = std::uint8_t;
constexpr Signs plus = 1;
constexpr Signs minus = 2;
constexpr Signs both = plus | minus;

class Viewpoint {
public:
    Viewpoint(const glm::dvec3& eye, Projection projection) : eye_{eye}, projection_{projection} {}
    [[nodiscard]] Signs sign(const glm::dvec3& position, const glm::dvec3& normal) const {
        const glm::dvec3 along = projection_ == Projection::Perspective ? position - eye_ : eye_;
        return glm::dot(normal, along) < 0.0 ? minus : plus;
    }

private:
    glm::dvec3 eye_;
    Projection projection_;
};

std::vector<Signs> signsOfFaces(const Mesh& mesh, const ControlMesh& control, const Viewpoint& viewpoint) {
    const std::vector<glm::dvec3> faceNormals = normalsOfTriangles(mesh);
    std::vector<Signs> signs(control.faceSizes.size(), 0);
    for (std::size_t t = 0; t < control.faces.size(); ++t) {
        if (control.faces[t] == noFace) continue;
        Signs& s = signs[control.faces[t]];
        for (std::size_t c = 3 * t; c < 3 * t + 3; ++c) {
            const std::uint32_t vertex = mesh.indices[c];
            s |= viewpoint.sign(glm::dvec3{mesh.positions[vertex]}, glm::dvec3{mesh.normals[vertex]});
        }
        const glm::dvec3 normal = faceNormals[t];
        if (normal != glm::dvec3{0.0}) s |= viewpoint.sign(glm::dvec3{mesh.positions[mesh.indices[3 * t]]}, normal);
    }
    return signs;
}

// Finds faces by the bits of their vertices. A vertex has the bits of all faces around it.
class Neighbourhood {
public:
    explicit Neighbourhood(const ControlMesh& control) : control_{control} {}

    /// For each face the bits of all faces that share a vertex with it.
    [[nodiscard]] std::vector<Signs> around(const std::vector<Signs>& faces) const {
        std::vector<Signs> vertices(control_.positions.size(), 0);
        forEachCorner([&](std::size_t face, std::size_t vertex) { vertices[vertex] |= faces[face]; });
        std::vector<Signs> result(faces.size(), 0);
        forEachCorner([&](std::size_t face, std::size_t vertex) { result[face] |= vertices[vertex]; });
        return result;
    }

private:
    template <class Visit>
    void forEachCorner(Visit&& visit) const {
        std::size_t corner = 0;
        for (std::size_t f = 0; f < control_.faceSizes.size(); ++f)
            for (std::int32_t k = 0; k < control_.faceSizes[f]; ++k)
                visit(f, static_cast<std::size_t>(control_.corners[corner++]));
    }
    const ControlMesh& control_;
};

}  // namespace

void subdivideMeshes(std::vector<Mesh>& meshes, const LoadSettings& settings) {
    double elements = 0.0;
    for (Mesh& mesh : meshes) {
        if (mesh.surfaces) continue;  // it is smooth already
        ControlMesh control = controlMeshOf(mesh, settings);
        if (control.faceSizes.empty()) continue;
        elements += refinedElements(control, settings.subdivide);
        // OpenSubdiv counts with 32 bits and a sign.
        const double maxElements = std::min(static_cast<double>(settings.limits.vertices),
                                            static_cast<double>(std::numeric_limits<std::int32_t>::max()));
        if (elements > maxElements)
            base::refuse(
                fmt::format("mesh {}: expected at most {:.0f} vertices and indices once subdivided {} times, "
                            "found {:.3g}; lower subdivide or raise max-vertices",
                            base::quote(mesh.name), maxElements, settings.subdivide, elements));
        mesh = subdivided(mesh, std::move(control), settings.subdivide);
    }
}

RefinedContourMesh refineNear(const Mesh& mesh, const ControlMesh& control, const glm::dvec3& eye,
                              Projection projection, int levels) {
    const Viewpoint view{projection == Projection::Perspective ? eye - mesh.origin : eye, projection};
    const Neighbourhood neighbourhood{control};
    std::vector<Signs> chosen = neighbourhood.around(signsOfFaces(mesh, control, view));
    for (Signs& s : chosen) s = s == both ? 1 : 0;
    const std::vector<Signs> needed = neighbourhood.around(chosen);
    std::vector<std::uint32_t> part;
    for (std::uint32_t f = 0; f < needed.size(); ++f)
        if (needed[f] != 0) part.push_back(f);
    RefinedContourMesh result;
    if (part.empty()) return result;

    RefinedFaces faces = refine(subsetOf(control, part), mesh.name, levels);
    const std::size_t size = cornersOf(control.scheme);
    const std::vector<std::uint32_t> divisions = trianglesOfFaces(control, levels);
    std::uint32_t number = 0;
    std::vector<std::uint32_t> renumbered(faces.positions.size(), noFace);
    for (std::size_t f = 0; f < faces.parents.size(); ++f) {
        const std::uint32_t parent = part[faces.parents[f]];
        if (chosen[parent] == 0) continue;
        for (std::size_t i = 0; i < 3 * (size - 2); ++i) {
            const std::uint32_t vertex = faces.corners[size * f + triangleCorners[i]];
            if (renumbered[vertex] == noFace) {
                renumbered[vertex] = static_cast<std::uint32_t>(result.positions.size());
                result.positions.push_back(faces.positions[vertex]);
                result.normals.push_back(faces.normals[vertex]);
            }
            result.indices.push_back(renumbered[vertex]);
        }
        result.controlTriangles.insert(result.controlTriangles.end(), size - 2, control.firstTriangles[parent]);
        if (f == 0 || faces.parents[f] != faces.parents[f - 1]) number = divisions[parent];
        for (std::size_t i = 0; i < size - 2; ++i) result.limitTriangles.push_back(number++);
    }
    return result;
}

}  // namespace inkedge::mesh
