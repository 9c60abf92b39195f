#include "mesh/authored_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/parallel.h"
#include "base/union_find.h"
#include "mesh/closed_surface.h"

namespace inkedge::mesh {
namespace {

// How far a believed normal may lie outside the normals of its faces. Exporters weight faces in different ways, and
// round to eight bits or less.
const double slack = glm::radians(10.0);
const double squareOfSlack = std::cos(slack) * std::cos(slack);

constexpr double maxStrangeShare = 0.25;  // of a component's corners, whose normals are still believed
constexpr double maxTurnedShare = 0.05;   // of a component's faces, in folds whose normals are smooth
constexpr int longestWalk = 32;           // faces around a point, to each side

// What the normals say of a face: bits.
constexpr std::uint8_t strangeCorners = 3;  // how many corners have a normal that is not among their faces'
constexpr std::uint8_t turned = 4;          // the normals point to the back
constexpr std::uint8_t judged = 8;          // the face has a normal of its own, and normals at its corners

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

// The angle between two lines.
double angleOfLines(const glm::dvec3& a, const glm::dvec3& b) {
    const double angle = angleBetween(a, b);
    return std::min(angle, glm::radians(180.0) - angle);
}

class Judge {
public:
    Judge(const Mesh& mesh, const MeshTopology& topology) : mesh_{mesh}, topology_{topology} {}

    [[nodiscard]] std::uint8_t face(std::uint32_t t) const {
        const glm::dvec3& own = topology_.faceNormals[t];
        const glm::dvec3 sum = normal(3 * t) + normal(3 * t + 1) + normal(3 * t + 2);
        if (own == glm::dvec3{0.0} || sum == glm::dvec3{0.0}) return 0;
        std::uint8_t found = judged;
        for (std::uint32_t c = 3 * t; c < 3 * t + 3; ++c)
            if (isStrange(c)) ++found;
        return glm::dot(own, sum) < 0.0 ? found | turned : found;
    }

private:
    [[nodiscard]] glm::dvec3 normal(std::uint32_t corner) const { return mesh_.normals[mesh_.indices[corner]]; }

    [[nodiscard]] bool isStrange(std::uint32_t corner) const {
        const glm::dvec3 authored = normal(corner);
        const glm::dvec3& own = topology_.faceNormals[corner / 3];
        if (authored == glm::dvec3{0.0}) return false;
        const double along = glm::dot(authored, own);
        if (along * along >= squareOfSlack * glm::dot(authored, authored)) return false;  // most of them
        std::array<glm::dvec3, 2 * longestWalk + 1> faces;
        std::size_t count = 0;
        faces[count++] = own;
        const auto add = [&](const glm::dvec3& face) { faces[count++] = face; };
        if (!walk(corner, corner, add)) walk(corner, previousHalfEdge(corner), add);
        glm::dvec3 mean{0.0};
        for (std::size_t i = 0; i < count; ++i) mean += faces[i];
        double spread = 0.0;
        for (std::size_t i = 0; i < count; ++i) spread = std::max(spread, angleBetween(mean, faces[i]));
        return angleOfLines(authored, mean) > spread + slack;
    }

    // Visits the faces around a point that share a corner's normal, as if all were wound alike.
    // @param across  the half-edge at the corner that is crossed first
    // @return        whether it came back to where it began
    template <class Visit>
    bool walk(std::uint32_t corner, std::uint32_t across, Visit visit) const {
        const glm::dvec3 authored = normal(corner);
        double side = 1.0;
        std::uint32_t at = corner;
        for (int step = 0; step < longestWalk; ++step) {
            const std::uint32_t twin = topology_.twins[across];
            if (!isHalfEdge(twin)) return false;
            const bool startsHere = topology_.points[twin] == topology_.points[at];
            const std::uint32_t next = startsHere ? twin : nextHalfEdge(twin);
            if (topology_.points[across] == topology_.points[twin]) side = -side;
            if (next == corner) return true;
            if (angleBetween(normal(next), authored) > sameNormal) return false;
            if (topology_.faceNormals[next / 3] != glm::dvec3{0.0}) visit(side * topology_.faceNormals[next / 3]);
            across = startsHere ? previousHalfEdge(next) : next;
            at = next;
        }
        return false;
    }

    const Mesh& mesh_;
    const MeshTopology& topology_;
};

std::vector<std::uint8_t> judgeFaces(const Mesh& mesh, const MeshTopology& topology) {
    std::vector<std::uint8_t> faces(topology.originals.size());
    const Judge judge{mesh, topology};
    base::inRanges(faces.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) faces[t] = judge.face(static_cast<std::uint32_t>(t));
    });
    return faces;
}

struct Component {
    std::uint32_t faces = 0;  // that were judged
    std::uint32_t strange = 0;
    std::uint32_t turned = 0;
    bool consistent = true;  // in its winding
};

enum class Verdict : std::uint8_t { Believe, TurnFaces, TurnAllFaces, Disbelieve };

// @param orientation  as componentOrientations() gives it
Verdict verdictOn(const Component& component, std::int8_t orientation) {
    const auto faces = static_cast<double>(component.faces);
    if (component.strange > maxStrangeShare * 3.0 * faces) return Verdict::Disbelieve;
    if (component.turned <= maxTurnedShare * faces) return component.consistent ? Verdict::Believe : Verdict::TurnFaces;
    if (!component.consistent) return Verdict::TurnFaces;
    const bool all = component.turned >= (1.0 - maxTurnedShare) * faces;
    return all && orientation < 0 ? Verdict::TurnAllFaces : Verdict::Disbelieve;
}

std::vector<Component> measure(const MeshTopology& topology, const std::vector<std::uint8_t>& faces,
                               base::UnionFind& sets) {
    for (std::uint32_t h = 0; h < topology.twins.size(); ++h)
        if (isHalfEdge(topology.twins[h])) sets.unite(h / 3, topology.twins[h] / 3);
    std::vector<Component> components(faces.size());
    for (std::uint32_t t = 0; t < faces.size(); ++t) {
        Component& component = components[sets.root(t)];
        for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
            const std::uint32_t twin = topology.twins[h];
            if (isHalfEdge(twin) && topology.points[h] == topology.points[twin]) component.consistent = false;
        }
        if ((faces[t] & judged) == 0) continue;
        ++component.faces;
        component.strange += faces[t] & strangeCorners;
        if ((faces[t] & turned) != 0) ++component.turned;
    }
    return components;
}

// Turns faces over, and keeps what the topology says of them.
void turnFaces(Mesh& mesh, MeshTopology& topology, const std::vector<bool>& isTurned) {
    const auto moved = [&](std::uint32_t h) {  // edges 0 and 2 of a triangle change places
        return isHalfEdge(h) && isTurned[h / 3] && h % 3 != 1 ? h - h % 3 + (2 - h % 3) : h;
    };
    for (std::uint32_t& twin : topology.twins) twin = moved(twin);
    for (std::uint32_t t = 0; t < isTurned.size(); ++t) {
        if (!isTurned[t]) continue;
        turnOver(mesh, 3 * std::size_t{t});
        std::swap(topology.points[3 * t + 1], topology.points[3 * t + 2]);
        std::swap(topology.twins[3 * t], topology.twins[3 * t + 2]);
        topology.faceNormals[t] = -topology.faceNormals[t];
    }
}

}  // namespace

void keepUsableNormals(Mesh& mesh, const LoadSettings& settings) {
    if (settings.normals == Normals::Flat) mesh.normals.clear();
    mesh.normals.resize(mesh.positions.size(), glm::vec3{0.0F});
    for (glm::vec3& normal : mesh.normals) {
        if (!std::isfinite(glm::dot(normal, normal))) normal = glm::vec3{0.0F};
    }
}

std::vector<bool> judgeNormals(Mesh& mesh, MeshTopology& topology, const LoadSettings& settings) {
    if (std::ranges::all_of(mesh.normals, [](glm::vec3 n) { return n == glm::vec3{0.0F}; })) return {};
    const std::vector<std::uint8_t> faces = judgeFaces(mesh, topology);
    if (std::ranges::all_of(faces, [](std::uint8_t face) { return (face & (strangeCorners | turned)) == 0; }))
        return {};

    const auto count = static_cast<std::uint32_t>(faces.size());
    base::UnionFind sets{count};
    const std::vector<Component> components = measure(topology, faces, sets);
    const std::vector<std::int8_t> orientations = componentOrientations(mesh, topology);
    std::vector<bool> isTurned(count, false);
    std::vector<bool> disbelieved(count, false);
    for (std::uint32_t t = 0; t < count; ++t) {
        const Verdict verdict = verdictOn(components[sets.root(t)], orientations[t]);
        disbelieved[t] = verdict == Verdict::Disbelieve;
        isTurned[t] = verdict == Verdict::TurnAllFaces || (verdict == Verdict::TurnFaces && (faces[t] & turned) != 0);
    }
    if (std::ranges::find(isTurned, true) != isTurned.end()) turnFaces(mesh, topology, isTurned);
    if (std::ranges::find(disbelieved, true) == disbelieved.end()) return {};
    if (settings.normals != Normals::Authored)
        for (std::size_t c = 0; c < mesh.indices.size(); ++c)
            if (disbelieved[c / 3]) mesh.normals[mesh.indices[c]] = glm::vec3{0.0F};
    return disbelieved;
}

}  // namespace inkedge::mesh
