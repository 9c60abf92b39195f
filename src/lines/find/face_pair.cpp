#include "lines/find/face_pair.h"

#include <limits>
#include <numbers>
#include <utility>

namespace inkedge::lines {
namespace {

constexpr double besides =
    std::numbers::pi / 180.0;  // faces around a line with a smaller angle between them lie on each other

// The part of a face that lies in the plane of another face: a segment of the line in which the planes meet.
struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    glm::dvec3 lowEnd{0.0};
    glm::dvec3 highEnd{0.0};
    int edge = -1;  // the edge that lies in the plane, if one does

    void add(double at, glm::dvec3 point) {
        if (at < low) low = at, lowEnd = point;
        if (at > high) high = at, highEnd = point;
    }
};

Span spanOf(const SideFace& face, const std::array<double, 3>& distances, glm::dvec3 along) {
    Span span;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (distances[k] == 0.0) span.add(glm::dot(along, face.corners[k]), face.corners[k]);
        if (distances[k] == 0.0 && distances[next] == 0.0) span.edge = static_cast<int>(k);
        if (distances[k] * distances[next] >= 0.0) continue;
        // Both faces of an edge find the same point, to the last bit.
        const auto [from, to] = face.points[k] < face.points[next] ? std::pair{k, next} : std::pair{next, k};
        const double share = distances[from] / (distances[from] - distances[to]);
        const glm::dvec3 point = face.corners[from] + share * (face.corners[to] - face.corners[from]);
        span.add(glm::dot(along, point), point);
    }
    return span;
}

double angleAbout(glm::dvec3 along, glm::dvec3 zero, glm::dvec3 direction) {
    return std::atan2(glm::dot(direction, glm::cross(along, zero)), glm::dot(direction, zero));
}

// Whether the two half-planes of one side and those of the other take turns about a line.
bool takeTurns(const std::array<double, 2>& a, const std::array<double, 2>& b) {
    constexpr double turn = 2.0 * std::numbers::pi;
    const auto from = [&](double angle) {  // a[0], 0 to a turn
        const double turned = std::fmod(angle - a[0], turn);
        return turned < 0.0 ? turned + turn : turned;
    };
    const double end = from(a[1]);
    int within = 0;
    for (const double angle : b) {
        const double at = from(angle);
        if (at < besides || at > turn - besides || std::abs(at - end) < besides) return false;
        within += at < end ? 1 : 0;
    }
    return within == 1;
}

}  // namespace

// The faces of one side that meet the line: the one that it runs across, or the two at the edge that lies on it.
struct FacePair::Around {
    std::array<SideFace, 2> faces;
    std::array<double, 2> angles;  // about the line, of the two half-planes that the side has there
    std::size_t count = 0;
};

SideFace faceOf(const FaceSide& side, std::uint32_t triangle) {
    SideFace face{triangle, {}, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        face.points[k] = side.topology->points[3 * std::size_t{triangle} + k];
        face.corners[k] = glm::dvec3{side.transform * glm::dvec4{glm::dvec3{side.tree->points[face.points[k]]}, 1.0}};
    }
    face.normal = glm::normalize(glm::cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]));
    return face;
}

std::optional<FaceCrossing> FacePair::crossPlanes(const SideFace& a, const Distances& distancesOfA, const SideFace& b,
                                                  const Distances& distancesOfB) const {
    const glm::dvec3 along = glm::normalize(glm::cross(a.normal, b.normal));
    const Span ofA = spanOf(a, distancesOfA, along);
    const Span ofB = spanOf(b, distancesOfB, along);
    const bool fromA = ofA.low >= ofB.low;
    const bool toA = ofA.high <= ofB.high;
    if ((toA ? ofA.high : ofB.high) - (fromA ? ofA.low : ofB.low) <= tolerance_) return {};
    if ((ofA.edge >= 0 || ofB.edge >= 0) && !crossesAtEdge(a, ofA.edge, b, ofB.edge, along)) return {};
    return FaceCrossing{a.triangle, b.triangle, {fromA ? ofA.lowEnd : ofB.lowEnd, toA ? ofA.highEnd : ofB.highEnd}};
}

// None if the edge is a line of its own.
std::optional<FacePair::Around> FacePair::around(const FaceSide& side, const SideFace& face, int edge, glm::dvec3 along,
                                                 glm::dvec3 zero) {
    if (edge < 0) {
        const double angle = angleAbout(along, zero, glm::cross(face.normal, along));
        return Around{{face, face}, {angle, angle + std::numbers::pi}, 1};
    }
    const std::uint32_t half = 3 * face.triangle + static_cast<std::uint32_t>(edge);
    const std::uint32_t twin = side.topology->twins[half];
    if (!mesh::isHalfEdge(twin) || side.topology->creases[half]) return {};
    if (side.normals[twin / 3] == glm::dvec3{0.0}) return {};
    const SideFace other = faceOf(side, twin / 3);
    const auto angleTo = [&](const SideFace& of, std::uint32_t apex) {
        return angleAbout(along, zero, of.corners[apex] - face.corners[static_cast<std::size_t>(edge)]);
    };
    return Around{{face, other},
                  {angleTo(face, (static_cast<std::uint32_t>(edge) + 2) % 3), angleTo(other, (twin % 3 + 2) % 3)},
                  2};
}

// Whether the two sides cross at the line, and whether these two of their faces are the ones that report it.
bool FacePair::crossesAtEdge(const SideFace& a, int edgeOfA, const SideFace& b, int edgeOfB, glm::dvec3 along) const {
    const std::optional<Around> ofA = around(a_, a, edgeOfA, along, a.normal);
    const std::optional<Around> ofB = around(b_, b, edgeOfB, along, a.normal);
    return ofA && ofB && takeTurns(ofA->angles, ofB->angles) && isFirst(*ofA, *ofB);
}

bool FacePair::isFirst(const Around& a, const Around& b) const {
    const auto rank = [&](const SideFace& x, const SideFace& y) {
        return sameMesh_ && y.triangle < x.triangle ? std::pair{y.triangle, x.triangle}
                                                    : std::pair{x.triangle, y.triangle};
    };
    const auto own = rank(a.faces[0], b.faces[0]);
    for (std::size_t i = 0; i < a.count; ++i) {
        for (std::size_t j = 0; j < b.count; ++j)
            if (mayCross(a.faces[i], b.faces[j]) && rank(a.faces[i], b.faces[j]) < own) return false;
    }
    return true;
}

}  // namespace inkedge::lines
