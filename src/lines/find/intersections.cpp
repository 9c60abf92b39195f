#include "lines/find/intersections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "base/parallel.h"
#include "lines/find/face_tree.h"
#include "mesh/topology.h"
#include "mesh/weld.h"
#include "scene/box_tree.h"
#include "scene/prepared.h"

namespace inkedge {
namespace {

using Nodes = std::vector<FaceTree::Node>;

const double leastAngle = glm::radians(leastIntersectionAngle);
const double flatCosine = std::cos(leastAngle);
constexpr double besides = std::numbers::pi / 180.0;  // faces around a line that part by less lie on each other

// Only a soup of faces in each other's way needs more than these.
constexpr std::uint64_t mostSteps = 50'000'000;  // pairs of nodes or faces that a task looks at
constexpr std::size_t mostSegmentsOfTask = 500'000;
constexpr std::size_t mostSegments = 10'000'000;

double lengthOfDiagonal(const Box& box) { return box.empty() ? 0.0 : glm::length(box.max - box.min); }

// A mesh as one of the two sides that may cross, placed in the space in which they are compared.
struct Side {
    const FaceTree* tree;
    const MeshTopology* topology;
    glm::dmat4 place;
};

struct Face {
    std::uint32_t triangle;
    std::array<std::uint32_t, 3> points;
    std::array<glm::dvec3, 3> corners;
    glm::dvec3 normal;
};

Face faceOf(const Side& side, std::uint32_t triangle) {
    Face face{triangle, {}, {}, {}};
    for (std::size_t k = 0; k < 3; ++k) {
        face.points[k] = side.topology->points[3 * std::size_t{triangle} + k];
        face.corners[k] = glm::dvec3{side.place * glm::dvec4{glm::dvec3{side.tree->points[face.points[k]]}, 1.0}};
    }
    face.normal = glm::normalize(glm::cross(face.corners[1] - face.corners[0], face.corners[2] - face.corners[0]));
    return face;
}

// A segment as a task finds it.
struct Found {
    std::uint32_t a;
    std::uint32_t b;
    std::array<glm::dvec3, 2> ends;
};

// What a face has in another one's plane.
struct Span {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    glm::dvec3 lowEnd{0.0};
    glm::dvec3 highEnd{0.0};
    int edge = -1;  // the edge that lies in the plane, if one does

    void add(double at, glm::dvec3 place) {
        if (at < low) low = at, lowEnd = place;
        if (at > high) high = at, highEnd = place;
    }
};

// Finds where two faces cross. The cases of touching are in the docstring of findIntersections().
class FacePair {
public:
    FacePair(const Side& a, const Side& b, double tolerance)
        : a_{a}, b_{b}, tolerance_{tolerance}, sameMesh_{&a == &b} {}

    [[nodiscard]] std::optional<Found> cross(const Face& a, const Face& b) const {
        if (!mayCross(a, b)) return {};
        const std::array<double, 3> distancesOfA = distances(a, b);
        if (allOnOneSide(distancesOfA)) return {};
        const std::array<double, 3> distancesOfB = distances(b, a);
        if (allOnOneSide(distancesOfB)) return {};
        const glm::dvec3 along = glm::normalize(glm::cross(a.normal, b.normal));
        const Span ofA = spanOf(a, distancesOfA, along);
        const Span ofB = spanOf(b, distancesOfB, along);
        const bool fromA = ofA.low >= ofB.low;
        const bool toA = ofA.high <= ofB.high;
        if ((toA ? ofA.high : ofB.high) - (fromA ? ofA.low : ofB.low) <= tolerance_) return {};
        if ((ofA.edge >= 0 || ofB.edge >= 0) && !crossesAtEdge(a, ofA.edge, b, ofB.edge, along)) return {};
        return Found{a.triangle, b.triangle, {fromA ? ofA.lowEnd : ofB.lowEnd, toA ? ofA.highEnd : ofB.highEnd}};
    }

private:
    [[nodiscard]] bool mayCross(const Face& a, const Face& b) const {
        if (sameMesh_) {
            for (const std::uint32_t p : a.points)
                if (p == b.points[0] || p == b.points[1] || p == b.points[2]) return false;
        }
        return std::abs(glm::dot(a.normal, b.normal)) < flatCosine;
    }

    // Of a face's corners from another one's plane; exactly 0 within the tolerance.
    [[nodiscard]] std::array<double, 3> distances(const Face& of, const Face& plane) const {
        std::array<double, 3> distances{};
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = glm::dot(plane.normal, of.corners[k] - plane.corners[0]);
            distances[k] = std::abs(d) <= tolerance_ ? 0.0 : d;
        }
        return distances;
    }

    // A face with one corner in the plane and the others to one side only touches it, one with three is in it.
    static bool allOnOneSide(const std::array<double, 3>& distances) {
        const auto above = std::ranges::count_if(distances, [](double d) { return d > 0.0; });
        const auto below = std::ranges::count_if(distances, [](double d) { return d < 0.0; });
        return above + below == 0 || (above + below > 1 && (above == 0 || below == 0));
    }

    static Span spanOf(const Face& face, const std::array<double, 3>& distances, glm::dvec3 along) {
        Span span;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t next = (k + 1) % 3;
            if (distances[k] == 0.0) span.add(glm::dot(along, face.corners[k]), face.corners[k]);
            if (distances[k] == 0.0 && distances[next] == 0.0) span.edge = static_cast<int>(k);
            if (distances[k] * distances[next] >= 0.0) continue;
            // Both faces of an edge find the same place, to the last bit.
            const auto [from, to] = face.points[k] < face.points[next] ? std::pair{k, next} : std::pair{next, k};
            const double share = distances[from] / (distances[from] - distances[to]);
            const glm::dvec3 place = face.corners[from] + share * (face.corners[to] - face.corners[from]);
            span.add(glm::dot(along, place), place);
        }
        return span;
    }

    // The faces of one side that meet the line: the one that it runs across, or the two at the edge that lies on it.
    struct Around {
        std::array<Face, 2> faces;
        std::array<double, 2> angles;  // about the line, of the two half-planes that the side has there
        std::size_t count = 0;
    };

    static double angleAbout(glm::dvec3 along, glm::dvec3 zero, glm::dvec3 direction) {
        return std::atan2(glm::dot(direction, glm::cross(along, zero)), glm::dot(direction, zero));
    }

    // None where the edge is a line of its own.
    [[nodiscard]] static std::optional<Around> around(const Side& side, const Face& face, int edge, glm::dvec3 along,
                                                      glm::dvec3 zero) {
        if (edge < 0) {
            const double angle = angleAbout(along, zero, glm::cross(face.normal, along));
            return Around{{face, face}, {angle, angle + std::numbers::pi}, 1};
        }
        const std::uint32_t half = 3 * face.triangle + static_cast<std::uint32_t>(edge);
        const std::uint32_t twin = side.topology->twins[half];
        if (!isHalfEdge(twin) || side.topology->creases[half]) return {};
        if (side.tree->normals[twin / 3] == glm::dvec3{0.0}) return {};
        const Face other = faceOf(side, twin / 3);
        const auto angleTo = [&](const Face& of, std::uint32_t apex) {
            return angleAbout(along, zero, of.corners[apex] - face.corners[static_cast<std::size_t>(edge)]);
        };
        return Around{{face, other},
                      {angleTo(face, (static_cast<std::uint32_t>(edge) + 2) % 3), angleTo(other, (twin % 3 + 2) % 3)},
                      2};
    }

    // Whether the two sides change places about the line, and whether these two of their faces are to say so.
    [[nodiscard]] bool crossesAtEdge(const Face& a, int edgeOfA, const Face& b, int edgeOfB, glm::dvec3 along) const {
        const std::optional<Around> ofA = around(a_, a, edgeOfA, along, a.normal);
        const std::optional<Around> ofB = around(b_, b, edgeOfB, along, a.normal);
        return ofA && ofB && changePlaces(ofA->angles, ofB->angles) && isFirst(*ofA, *ofB);
    }

    static bool changePlaces(const std::array<double, 2>& a, const std::array<double, 2>& b) {
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

    [[nodiscard]] bool isFirst(const Around& a, const Around& b) const {
        const auto rank = [&](const Face& x, const Face& y) {
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

    const Side& a_;
    const Side& b_;
    double tolerance_;
    bool sameMesh_;
};

// A node's box where the other side's boxes are.
struct PlacedBox {
    glm::vec3 low;
    glm::vec3 high;
    glm::vec3 axis;
};

// Two sides and the pairs of nodes in which their faces may cross.
class Pairing {
public:
    // One mesh against itself.
    Pairing(const Side& side, double tolerance) : Pairing{side, side, tolerance} {}

    // @param tolerance  in the space that both are placed in
    Pairing(const Side& a, const Side& b, double tolerance)
        : a_{a}, b_{b}, faces_{a, b, tolerance}, sameMesh_{&a == &b} {
        const glm::dmat4 toA = sameMesh_ ? glm::dmat4{1.0} : glm::inverse(a.place) * b.place;
        toA_ = glm::mat3{glm::dmat3{toA}};
        offset_ = glm::vec3{toA[3]};
        for (int i = 0; i < 3; ++i) absolute_[i] = glm::abs(toA_[i]);
        scale_ = static_cast<float>(glm::length(glm::dvec3{toA[0]}));
        // Boxes of floats, moved by floats: off by a few roundings of the largest number that occurs.
        const FaceTree::Node& rootOfA = a.tree->nodes.front();
        const FaceTree::Node& rootOfB = b.tree->nodes.front();
        const double reach =
            glm::length(glm::dvec3{offset_}) + glm::length(glm::dvec3{rootOfA.high - rootOfA.low}) +
            double{scale_} * glm::length(glm::dvec3{glm::max(glm::abs(rootOfB.low), glm::abs(rootOfB.high))});
        const double scaleOfA = glm::length(glm::dvec3{a.place[0]});
        margin_ = static_cast<float>(tolerance / scaleOfA + (sameMesh_ ? 0.0 : 1e-6 * reach));
    }

    struct Task {
        std::uint32_t first;
        std::uint32_t second;
    };

    // Splits the work into tasks of about the same size, the same ones whatever the machine.
    [[nodiscard]] std::vector<Task> tasks() const {
        std::vector<Task> tasks{{0, 0}};
        const std::size_t wanted =
            std::min<std::size_t>(256, (a_.tree->triangles.size() + b_.tree->triangles.size()) / 4096);
        std::vector<Task> split;
        for (std::size_t before = 0; tasks.size() < wanted && tasks.size() != before;) {
            before = tasks.size();
            split.clear();
            for (const Task& task : tasks) expand(task, [&](Task part) { split.push_back(part); });
            tasks.swap(split);
        }
        return tasks;
    }

    [[nodiscard]] std::vector<Found> find(Task task) const {
        Search search{mostSteps, {}};
        visit(task, search);
        return std::move(search.found);
    }

private:
    struct Search {
        std::uint64_t stepsLeft;
        std::vector<Found> found;
    };

    [[nodiscard]] const Nodes& nodesOfA() const { return a_.tree->nodes; }
    [[nodiscard]] const Nodes& nodesOfB() const { return b_.tree->nodes; }

    // The parts of a task that may hold a crossing: itself where it is small enough to be looked at.
    template <class Take>
    void expand(Task task, Take&& take) const {
        const FaceTree::Node& a = nodesOfA()[task.first];
        const FaceTree::Node& b = nodesOfB()[task.second];
        if (sameMesh_ && task.first == task.second) {
            if (2.0F * a.angle < static_cast<float>(leastAngle)) return;
            if (a.second == 0) return take(task);
            take({task.first + 1, task.first + 1});
            take({a.second, a.second});
            return take({task.first + 1, a.second});
        }
        if (apart(a, b)) return;
        if (a.second == 0 && b.second == 0) return take(task);
        if (b.second == 0 || (a.second != 0 && a.end - a.begin >= b.end - b.begin)) {
            take({task.first + 1, task.second});
            take({a.second, task.second});
        } else {
            take({task.first, task.second + 1});
            take({task.first, b.second});
        }
    }

    [[nodiscard]] PlacedBox placed(const FaceTree::Node& b) const {
        if (sameMesh_) return {b.low, b.high, b.axis};
        const glm::vec3 centre = toA_ * (0.5F * (b.low + b.high)) + offset_;
        const glm::vec3 half = absolute_ * (0.5F * (b.high - b.low));
        return {centre - half, centre + half, toA_ * b.axis / scale_};
    }

    // Whether no face of one can cross one of the other: their boxes part, or all of them are nearly parallel.
    [[nodiscard]] bool apart(const FaceTree::Node& a, const FaceTree::Node& nodeOfB) const {
        const PlacedBox b = placed(nodeOfB);
        if (a.low.x > b.high.x + margin_ || b.low.x > a.high.x + margin_ || a.low.y > b.high.y + margin_ ||
            b.low.y > a.high.y + margin_ || a.low.z > b.high.z + margin_ || b.low.z > a.high.z + margin_)
            return true;
        const float left = static_cast<float>(leastAngle) - a.angle - nodeOfB.angle - 1e-3F;
        if (left <= 0.0F) return false;
        const float square = left * left;
        return std::abs(glm::dot(a.axis, b.axis)) > 1.0F - square * (0.5F - square / 24.0F);  // over the cosine of left
    }

    void visit(Task task, Search& search) const {
        if (search.stepsLeft == 0) return;
        --search.stepsLeft;
        expand(task, [&](Task part) {
            if (part.first == task.first && part.second == task.second)
                compareLeaves(part, search);
            else
                visit(part, search);
        });
    }

    void compareLeaves(Task task, Search& search) const {
        const FaceTree::Node& a = nodesOfA()[task.first];
        const FaceTree::Node& b = nodesOfB()[task.second];
        search.stepsLeft -= std::min<std::uint64_t>(search.stepsLeft, (a.end - a.begin) * (b.end - b.begin));
        if (!sameMesh_) return compareFaces(a, b, search);
        const bool sameLeaf = task.first == task.second;
        for (std::uint32_t i = a.begin; i < a.end; ++i) {
            for (std::uint32_t j = sameLeaf ? i + 1 : b.begin; j < b.end; ++j) {
                const auto [first, second] = std::minmax(a_.tree->triangles[i], a_.tree->triangles[j]);
                if (shareAPoint(first, second) || partAlongAxes(first, second)) continue;
                const double cosine = glm::dot(a_.tree->normals[first], a_.tree->normals[second]);
                if (std::abs(cosine) < flatCosine) compare(faceOf(a_, first), faceOf(a_, second), search);
            }
        }
    }

    void compareFaces(const FaceTree::Node& a, const FaceTree::Node& b, Search& search) const {
        std::array<Face, FaceTree::leafSize> facesOfB;
        for (std::uint32_t j = b.begin; j < b.end; ++j) facesOfB[j - b.begin] = faceOf(b_, b_.tree->triangles[j]);
        for (std::uint32_t i = a.begin; i < a.end; ++i) {
            const Face faceOfA = faceOf(a_, a_.tree->triangles[i]);
            for (std::uint32_t j = b.begin; j < b.end; ++j) compare(faceOfA, facesOfB[j - b.begin], search);
        }
    }

    void compare(const Face& first, const Face& second, Search& search) const {
        const std::optional<Found> found = faces_.cross(first, second);
        if (!found) return;
        if (search.found.size() < mostSegmentsOfTask)
            search.found.push_back(*found);
        else
            search.stepsLeft = 0;
    }

    [[nodiscard]] bool shareAPoint(std::uint32_t first, std::uint32_t second) const {
        const std::uint32_t* const p = &a_.topology->points[3 * std::size_t{first}];
        const std::uint32_t* const q = &a_.topology->points[3 * std::size_t{second}];
        const auto isOneOfQ = [&](std::uint32_t point) { return point == q[0] || point == q[1] || point == q[2]; };
        return isOneOfQ(p[0]) || isOneOfQ(p[1]) || isOneOfQ(p[2]);
    }

    [[nodiscard]] bool partAlongAxes(std::uint32_t first, std::uint32_t second) const {
        const std::uint32_t* const p = &a_.topology->points[3 * std::size_t{first}];
        const std::uint32_t* const q = &a_.topology->points[3 * std::size_t{second}];
        const std::vector<glm::vec3>& points = a_.tree->points;
        const glm::vec3 lowOfP = glm::min(glm::min(points[p[0]], points[p[1]]), points[p[2]]);
        const glm::vec3 highOfP = glm::max(glm::max(points[p[0]], points[p[1]]), points[p[2]]);
        const glm::vec3 lowOfQ = glm::min(glm::min(points[q[0]], points[q[1]]), points[q[2]]);
        const glm::vec3 highOfQ = glm::max(glm::max(points[q[0]], points[q[1]]), points[q[2]]);
        return lowOfP.x > highOfQ.x + margin_ || lowOfQ.x > highOfP.x + margin_ || lowOfP.y > highOfQ.y + margin_ ||
               lowOfQ.y > highOfP.y + margin_ || lowOfP.z > highOfQ.z + margin_ || lowOfQ.z > highOfP.z + margin_;
    }

    const Side& a_;
    const Side& b_;
    FacePair faces_;
    bool sameMesh_;
    glm::mat3 toA_{1.0F};
    glm::vec3 offset_{0.0F};
    glm::mat3 absolute_{1.0F};
    float scale_ = 1.0F;
    float margin_ = 0.0F;
};

// The segments of one pairing, sorted, their ends numbered.
struct Crossing {
    std::vector<Found> segments;
    std::vector<std::uint32_t> nodes;  // two a segment
    std::uint32_t nodeCount = 0;
};

// @param tolerance  ends that lie closer to each other are one
void numberEnds(Crossing& crossing, double tolerance) {
    if (crossing.segments.empty()) return;
    const glm::dvec3 origin = crossing.segments.front().ends[0];
    std::vector<glm::vec3> places;
    places.reserve(2 * crossing.segments.size() + 1);
    for (const Found& found : crossing.segments)
        for (const glm::dvec3& end : found.ends) places.emplace_back(end - origin);
    // Far enough away for the tolerance, which goes by the box, to be what it should; no end is there.
    places.emplace_back(glm::vec3{static_cast<float>(tolerance / weldTolerance)});
    const Weld weld = weldByPosition(places);
    crossing.nodes.assign(weld.point.begin(), weld.point.end() - 1);
    crossing.nodeCount = weld.pointCount - 1;
}

class Finder {
public:
    explicit Finder(const Scene& scene) : scene_{scene}, sides_(scene.meshes().size()) {}

    std::vector<IntersectionSegment> find() {
        buildTrees();
        findWithinMeshes();
        for (std::uint32_t i = 0; i < scene_.instances().size(); ++i) placed_.push_back(placedSide(i));
        findBetweenInstances();
        return collect();
    }

private:
    struct InstancePair {
        std::uint32_t a;
        std::uint32_t b;
    };

    [[nodiscard]] static bool isFlat(const glm::dmat4& transform) {
        return glm::determinant(glm::dmat3{transform}) == 0.0;
    }

    void buildTrees() {
        trees_.resize(scene_.meshes().size());
        onEach(trees_.size(), [&](std::size_t i) {
            trees_[i] = buildFaceTree(scene_.meshes()[i], topologyOf(scene_, i), leastAngle);
            sides_[i] = {&trees_[i], &topologyOf(scene_, i), glm::dmat4{1.0}};
        });
    }

    [[nodiscard]] double toleranceOf(std::uint32_t mesh) const {
        return weldTolerance * lengthOfDiagonal(scene_.meshBox(mesh));
    }

    void findWithinMeshes() {
        std::vector<Pairing> pairings;
        std::vector<double> tolerances;
        std::vector<std::size_t> meshes;
        for (std::size_t i = 0; i < trees_.size(); ++i) {
            if (trees_[i].nodes.empty()) continue;
            tolerances.push_back(toleranceOf(static_cast<std::uint32_t>(i)));
            pairings.emplace_back(sides_[i], tolerances.back());
            meshes.push_back(i);
        }
        within_.resize(trees_.size());
        std::vector<Crossing> found = run(pairings, tolerances);
        for (std::size_t i = 0; i < meshes.size(); ++i) within_[meshes[i]] = std::move(found[i]);
    }

    [[nodiscard]] Side placedSide(std::uint32_t i) const {
        const Instance& instance = scene_.instances()[i];
        Side side = sides_[instance.mesh];
        side.place = instance.transform;
        side.place[3] += side.place * glm::dvec4{scene_.meshes()[instance.mesh].origin, 0.0} -
                         glm::dvec4{scene_.bounds().centre, 0.0};
        return side;
    }

    [[nodiscard]] double placedTolerance(std::uint32_t i) const {
        return toleranceOf(scene_.instances()[i].mesh) * glm::length(glm::dvec3{placed_[i].place[0]});
    }

    [[nodiscard]] Box placedBox(std::uint32_t i) const {
        const Box& box = scene_.meshBox(scene_.instances()[i].mesh);
        const glm::dmat4& place = placed_[i].place;
        const glm::dvec3 centre{place * glm::dvec4{0.5 * (box.min + box.max), 1.0}};
        const glm::dvec3 half = 0.5 * (box.max - box.min);
        const glm::dvec3 reach = glm::abs(glm::dvec3{place[0]}) * half.x + glm::abs(glm::dvec3{place[1]}) * half.y +
                                 glm::abs(glm::dvec3{place[2]}) * half.z + placedTolerance(i);
        return {centre - reach, centre + reach};
    }

    void findPairs() {
        std::vector<std::uint32_t> instances;
        std::vector<Box> boxes;
        for (std::uint32_t i = 0; i < placed_.size(); ++i) {
            if (placed_[i].tree->nodes.empty() || isFlat(placed_[i].place)) continue;
            instances.push_back(i);
            boxes.push_back(placedBox(i));
        }
        const BoxTree tree{boxes};
        std::uint64_t stepsLeft = 100'000'000 + 1000 * std::uint64_t{boxes.size()};
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const std::size_t before = pairs_.size();
            tree.forEachOverlap(boxes[i], stepsLeft, [&](std::uint32_t j) {
                if (j > i) pairs_.push_back({instances[i], instances[j]});
            });
            std::sort(pairs_.begin() + static_cast<std::ptrdiff_t>(before), pairs_.end(),
                      [](const InstancePair& x, const InstancePair& y) { return x.b < y.b; });
        }
    }

    void findBetweenInstances() {
        findPairs();
        std::vector<Pairing> pairings;
        std::vector<double> tolerances;
        pairings.reserve(pairs_.size());
        for (const InstancePair& pair : pairs_) {
            tolerances.push_back(std::max(placedTolerance(pair.a), placedTolerance(pair.b)));
            pairings.emplace_back(placed_[pair.a], placed_[pair.b], tolerances.back());
        }
        between_ = run(pairings, tolerances);
    }

    static std::vector<Crossing> run(const std::vector<Pairing>& pairings, const std::vector<double>& tolerances) {
        struct Part {
            std::size_t pairing;
            Pairing::Task task;
            std::vector<Found> found;
        };
        std::vector<Part> parts;
        for (std::size_t i = 0; i < pairings.size(); ++i)
            for (const Pairing::Task& task : pairings[i].tasks()) parts.push_back({i, task, {}});
        onEach(parts.size(), [&](std::size_t i) { parts[i].found = pairings[parts[i].pairing].find(parts[i].task); });

        std::vector<Crossing> crossings(pairings.size());
        for (Part& part : parts) {
            std::vector<Found>& segments = crossings[part.pairing].segments;
            segments.insert(segments.end(), part.found.begin(), part.found.end());
            part.found = std::vector<Found>{};
        }
        onEach(crossings.size(), [&](std::size_t i) {
            std::ranges::sort(crossings[i].segments, {}, [](const Found& f) { return std::pair{f.a, f.b}; });
            numberEnds(crossings[i], 2.0 * tolerances[i]);
        });
        return crossings;
    }

    [[nodiscard]] std::vector<IntersectionSegment> collect() const {
        std::vector<IntersectionSegment> segments;
        auto pair = pairs_.begin();
        std::uint32_t firstNode = 0;
        const auto add = [&](const Crossing& crossing, InstancePair of, const glm::dmat4& place) {
            if (segments.size() + crossing.segments.size() > mostSegments) return;
            for (std::size_t i = 0; i < crossing.segments.size(); ++i) {
                const Found& found = crossing.segments[i];
                const auto placed = [&](glm::dvec3 end) { return glm::dvec3{place * glm::dvec4{end, 1.0}}; };
                segments.push_back({{of.a, found.a},
                                    {of.b, found.b},
                                    {placed(found.ends[0]), placed(found.ends[1])},
                                    {firstNode + crossing.nodes[2 * i], firstNode + crossing.nodes[2 * i + 1]}});
            }
            firstNode += crossing.nodeCount;
        };
        for (std::uint32_t i = 0; i < placed_.size(); ++i) {
            if (!isFlat(placed_[i].place)) add(within_[scene_.instances()[i].mesh], {i, i}, placed_[i].place);
            for (; pair != pairs_.end() && pair->a == i; ++pair)
                add(between_[static_cast<std::size_t>(pair - pairs_.begin())], *pair, glm::dmat4{1.0});
        }
        return segments;
    }

    const Scene& scene_;
    std::vector<FaceTree> trees_;
    std::vector<Side> sides_;       // one a mesh, in its own space less its origin
    std::vector<Crossing> within_;  // one a mesh, likewise
    std::vector<Side> placed_;      // one an instance, in world space less the scene's middle
    std::vector<InstancePair> pairs_;
    std::vector<Crossing> between_;  // one a pair
};

}  // namespace

std::vector<IntersectionSegment> findIntersections(const Scene& scene) { return Finder{scene}.find(); }

}  // namespace inkedge
