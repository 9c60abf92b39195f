#include "lines/find/form_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/parallel.h"
#include "lines/find/instance_view.h"
#include "lines/find/traced_form.h"
#include "lines/find/view_curvature.h"
#include "scene/prepared.h"

namespace inkedge::lines {
namespace {

constexpr double tiny = 1e-30;  // in place of 0: which side of the line it is does not change with the direction
/// Surfaces that lie across the view have no suggestive contours: sines of the angle between them.
constexpr double minSine = 0.25;
constexpr double fullSine = 0.5;
constexpr double minCosine = 0.1;      // nearer to a contour there are no apparent ridges but the contour
constexpr double sharpness = 0.2;      // of a ridge: curvature'' / curvature^3, where it counts in full
constexpr double sameDirection = 0.5;  // cosine: neighbouring directions that differ more have no line between them

class FormFinder {
public:
    FormFinder(const Scene& scene, std::uint32_t instance, const mesh::SurfaceForm& form, const MeshEdges& edges,
               const Screen& screen, const FormChoice& choice, std::vector<Segment>& to)
        : instance_{instance},
          mesh_{scene.meshes()[scene.instances()[instance].mesh]},
          topology_{scene::topologyOf(scene, scene.instances()[instance].mesh)},
          form_{form},
          edges_{edges},
          choice_{choice},
          to_{to},
          view_{scene, instance, screen} {}

    void find() {
        if (view_.scale == 0.0 || form_.points.empty()) return;
        for (const double size : form_.resolutions) minLengths_.push_back(minFormLength * size);
        const FormSettings& settings = choice_.settings;
        if (draws(LineType::Suggestive)) addSuggestive(settings.suggestiveThreshold);
        if (draws(LineType::Ridge)) addExtrema(Curve::Ridge, settings.ridgeThreshold);
        if (draws(LineType::Valley)) addExtrema(Curve::Valley, settings.ridgeThreshold);
        if (draws(LineType::Apparent)) addApparent(settings.apparentThreshold);
    }

private:
    [[nodiscard]] bool draws(LineType type) const { return choice_.types.contains(type); }
    [[nodiscard]] glm::dvec3 position(std::uint32_t corner) const {
        return glm::dvec3{mesh_.positions[mesh_.indices[corner]]};
    }
    // From a point to the eye.
    [[nodiscard]] glm::dvec3 toEye(glm::dvec3 p) const { return -view_.eye.view(p); }

    // Whether a face is seen from behind, and its closed component hides it.
    [[nodiscard]] bool isHidden(std::uint32_t t) const {
        if (!choice_.eyeOutside || edges_.closed[t] == 0) return false;
        return glm::dot(edges_.faceNormals[t], toEye(position(3 * t))) * edges_.closed[t] <= 0.0;
    }

    [[nodiscard]] FormFace faceOf(std::uint32_t t) const {
        FormFace face{t, {}, {}};
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t h = 3 * t + k;
            const std::uint32_t twin = topology_.twins[h];
            face.positions[k] = position(h);
            face.edges[k] = mesh::isHalfEdge(twin) && !topology_.creases[h] ? std::min(h, twin) : h;
        }
        return face;
    }

    [[nodiscard]] const mesh::PointForm& pointOf(std::uint32_t t, std::uint32_t k) const {
        return form_.points[form_.fans[3 * t + k]];
    }

    // One value per fan, at the position of one of its corners.
    template <class Value, class ValueAt>
    std::vector<Value> onFans(ValueAt&& valueAt) const {
        std::vector<std::uint32_t> corners(form_.points.size());
        for (std::uint32_t c = 0; c < form_.fans.size(); ++c) corners[form_.fans[c]] = c;
        std::vector<Value> values(form_.points.size());
        base::inRanges(values.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t fan = begin; fan < end; ++fan) values[fan] = valueAt(form_.points[fan], corners[fan]);
        });
        return values;
    }

    // @param cornersOf  of a face to its three FormCorner, or none
    template <class CornersOf>
    void add(Curve curve, double threshold, CornersOf&& cornersOf) {
        std::vector<FormSegment> found;
        for (std::uint32_t t = 0; t < topology_.patches.size(); ++t) {
            const std::optional<std::array<FormCorner, 3>> corners = cornersOf(t);
            if (corners && topology_.originals[t] == t)
                traceThrough(faceOf(t), *corners, weakestForm * threshold, found);
        }
        for (const FormSegment& line : strongLines(std::move(found), threshold, minLengths_, topology_))
            addSegment(curve, threshold, line);
    }

    void addSegment(Curve curve, double threshold, const FormSegment& line) {
        const bool hidden = isHidden(line.triangle);
        if (hidden && choice_.hidden == HiddenLines::None) return;
        Segment& segment = to_.emplace_back();
        segment.curve = curve;
        segment.hidden = hidden;
        segment.occludes = false;
        segment.faces[0] = {instance_, line.triangle};
        for (std::size_t k = 0; k < 2; ++k) {
            segment.ends[k] = view_.world(line.ends[k]);
            if (line.edges[k] != mesh::noHalfEdge) segment.keys[k] = formKey(instance_, line.edges[k]);
            const double share = threshold > 0.0 ? line.strengths[k] / threshold : fullForm;
            segment.strengths[k] = std::clamp((share - weakestForm) / (fullForm - weakestForm), 0.0, 1.0);
        }
    }

    void addSuggestive(double threshold) {
        const auto curvatures = onFans<float>([&](const mesh::PointForm& point, std::uint32_t corner) {
            return static_cast<float>(radialCurvature(point, toEye(position(corner))).curvature);
        });
        add(Curve::Suggestive, threshold, [&](std::uint32_t t) -> std::optional<std::array<FormCorner, 3>> {
            const auto isOver = [&](std::uint32_t k) { return curvatures[form_.fans[3 * t + k]] > 0.0F; };
            if (isOver(0) == isOver(1) && isOver(1) == isOver(2)) return std::nullopt;
            std::array<RadialCurvature, 3> radial{};
            double side = 0.0;
            for (std::uint32_t k = 0; k < 3; ++k) {
                radial[k] = radialCurvature(pointOf(t, k), toEye(position(3 * t + k)));
                side += radial[k].cosine;
            }
            std::array<FormCorner, 3> corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                RadialCurvature& at = radial[k];
                if (side < 0.0) at = {-at.cosine, at.sine, -at.curvature, -at.torsion, -at.derivative};
                const double clear = std::clamp((at.sine - minSine) / (fullSine - minSine), 0.0, 1.0);
                const double growth = growthTowardsEye(at);
                const double strength = std::copysign(std::sqrt(std::abs(growth)), growth);
                corners[k] = {at.curvature, clear > 0.0 ? clear * strength : -std::abs(strength), at.cosine};
            }
            return corners;
        });
    }

    // Whether what bulges to a face's front is hollow as it is seen.
    [[nodiscard]] bool isTurnedOver(std::uint32_t t) const {
        if (choice_.eyeOutside && edges_.closed[t] != 0) return edges_.closed[t] < 0;
        return glm::dot(edges_.faceNormals[t], toEye(position(3 * t))) < 0.0;
    }

    // Ridges, or the ridges of the surface turned over.
    void addExtrema(Curve curve, double threshold) {
        add(curve, threshold, [&](std::uint32_t t) -> std::optional<std::array<FormCorner, 3>> {
            const bool valley = (curve == Curve::Valley) != isTurnedOver(t);
            std::array<glm::dvec3, 3> directions{};
            std::array<FormCorner, 3> corners{};
            for (std::uint32_t k = 0; k < 3; ++k) {
                const mesh::PointForm& point = pointOf(t, k);
                const auto own = static_cast<double>(valley ? -point.curvatures[1] : point.curvatures[0]);
                const auto other = static_cast<double>(valley ? -point.curvatures[0] : point.curvatures[1]);
                const auto growth = static_cast<double>(valley ? -point.derivative[3] : point.derivative[0]);
                directions[k] =
                    valley ? glm::cross(glm::dvec3{point.normal}, glm::dvec3{point.first}) : glm::dvec3{point.first};
                corners[k] = {growth, own > std::abs(other) ? own : -1.0};
            }
            return turnedAlike(t, directions, corners);
        });
    }

    void addApparent(double threshold) {
        struct Values {
            glm::vec3 direction;
            float curvature;
            float derivative;
            float cosine;
        };
        const auto seen = onFans<Values>([&](const mesh::PointForm& point, std::uint32_t corner) {
            const double size = form_.featureSizes[topology_.patches[corner / 3]];
            if (size == 0.0) return Values{};
            const ApparentCurvature at =
                apparentCurvature(point, toEye(position(corner)) / size, view_.eye.orthographic);
            return Values{glm::vec3{at.direction}, static_cast<float>(at.curvature), static_cast<float>(at.derivative),
                          static_cast<float>(at.cosine)};
        });
        add(Curve::Apparent, threshold, [&](std::uint32_t t) -> std::optional<std::array<FormCorner, 3>> {
            std::array<glm::dvec3, 3> directions{};
            std::array<FormCorner, 3> corners{};
            for (std::uint32_t k = 0; k < 3; ++k) {
                const Values& at = seen[form_.fans[3 * t + k]];
                if (static_cast<double>(at.cosine) < minCosine) return std::nullopt;
                directions[k] = glm::dvec3{at.direction};
                corners[k] = {static_cast<double>(at.derivative), static_cast<double>(at.curvature)};
            }
            return turnedAlike(t, directions, corners);
        });
    }

    // The derivatives of a curvature at the corners of a face, with the directions that they are of turned to one side;
    // none if there is no maximum of the curvature between them. A direction's sign is any.
    [[nodiscard]] std::optional<std::array<FormCorner, 3>> turnedAlike(std::uint32_t t,
                                                                       std::array<glm::dvec3, 3> directions,
                                                                       std::array<FormCorner, 3> corners) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (corners[k].value == 0.0) corners[k].value = tiny;
            if (k == 0 || glm::dot(directions[k], directions[0]) >= 0.0) continue;
            directions[k] = -directions[k];
            corners[k].value = -corners[k].value;
        }
        const bool over = corners[0].value > 0.0;
        if (over == (corners[1].value > 0.0) && over == (corners[2].value > 0.0)) return std::nullopt;
        if (glm::dot(directions[1], directions[2]) < sameDirection ||
            glm::dot(directions[0], directions[1]) < sameDirection ||
            glm::dot(directions[0], directions[2]) < sameDirection)
            return std::nullopt;
        const double second = growthAlong(t, glm::normalize(directions[0] + directions[1] + directions[2]),
                                          {corners[0].value, corners[1].value, corners[2].value});
        if (!(second < 0.0)) return std::nullopt;
        for (FormCorner& corner : corners) {
            const double full = sharpness * corner.strength * corner.strength * corner.strength;
            if (corner.strength > 0.0 && -second < full) corner.strength *= -second / full;
        }
        return corners;
    }

    // How fast a value that is linear in a face grows along a direction, per feature size.
    [[nodiscard]] double growthAlong(std::uint32_t t, glm::dvec3 direction, std::array<double, 3> values) const {
        const glm::dvec3 a = position(3 * t);
        const glm::dvec3 u = position(3 * t + 1) - a;
        const glm::dvec3 v = position(3 * t + 2) - a;
        const glm::dvec3 normal = glm::cross(u, v);
        const double square = glm::dot(normal, normal);
        if (square == 0.0) return 0.0;
        const glm::dvec3 gradient =
            (glm::cross(v, normal) * (values[1] - values[0]) + glm::cross(normal, u) * (values[2] - values[0])) /
            square;
        return glm::dot(gradient, direction) * form_.featureSizes[topology_.patches[t]];
    }

    std::uint32_t instance_;
    const Mesh& mesh_;
    const mesh::MeshTopology& topology_;
    const mesh::SurfaceForm& form_;
    const MeshEdges& edges_;
    const FormChoice& choice_;
    std::vector<Segment>& to_;
    InstanceView view_;
    std::vector<double> minLengths_;  // one per patch
};

}  // namespace

void addFormLines(const Scene& scene, std::uint32_t instance, const mesh::SurfaceForm& form, const MeshEdges& edges,
                  const Screen& screen, const FormChoice& choice, std::vector<Segment>& to) {
    FormFinder{scene, instance, form, edges, screen, choice, to}.find();
}

}  // namespace inkedge::lines
