#include "formats/cad/fineness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <inkedge/scene.h>
#include <inkedge/views.h>

namespace inkedge::cad {
namespace {

constexpr double unseen = 16.0;  // times as coarse as the finest
constexpr double finest = 1e-7;  // of the model's size

// Those of faces without an end are infinite.
std::vector<glm::dvec3> usable(std::vector<glm::dvec3> points) {
    constexpr double largest = 1e30;  // millimetres
    std::erase_if(points, [](const glm::dvec3& p) {
        return !(std::abs(p.x) < largest && std::abs(p.y) < largest && std::abs(p.z) < largest);
    });
    return points;
}

// A scene with the extent of the parts, to find cameras for.
Scene standIn(const Outline& outline, glm::dvec3 up, const LoadSettings& settings) {
    Scene::Data data;
    data.source.up = up;
    data.source.unit = settings.unit != LengthUnit::None ? settings.unit : LengthUnit::Millimetre;
    for (const std::vector<glm::dvec3>& all : outline.parts) {
        Mesh& mesh = data.meshes.emplace_back();
        const std::vector<glm::dvec3> points = usable(all);
        if (points.empty()) continue;
        mesh.origin = points.front();
        for (const glm::dvec3& point : points) mesh.lines.emplace_back(point - mesh.origin);
        if (points.size() % 2 != 0) mesh.lines.push_back(mesh.lines.back());
    }
    for (const cad::Instance& instance : outline.instances) {
        inkedge::Instance& added = data.instances.emplace_back();
        added.mesh = instance.part;
        added.transform = instance.transform;
    }
    return Scene{std::move(data)};
}

std::vector<FramedView> framedViews(const Scene& scene, const LoadSettings& settings) {
    Settings of;
    of.picture = settings.pictures.picture;
    of.frame = settings.pictures.frame;
    std::vector<View> views;
    for (const CameraSettings& camera : settings.pictures.cameras) views.push_back({{}, camera});
    if (views.empty()) views.emplace_back();
    if (framedTogether(views)) return frameViews(scene, views, of);
    std::vector<FramedView> framed;
    for (const View& view : views) framed.push_back(frameViews(scene, {&view, 1}, of).front());
    return framed;
}

std::array<glm::dvec3, 8> cornersOf(const Box& box) {
    std::array<glm::dvec3, 8> corners{};
    for (std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = {(i & 1U) != 0 ? box.max.x : box.min.x, (i & 2U) != 0 ? box.max.y : box.min.y,
                      (i & 4U) != 0 ? box.max.z : box.min.z};
    return corners;
}

// The width of a pixel in the world where a view shows a box the largest; infinite: it does not show the box.
double footprintIn(const FramedView& view, const std::array<glm::dvec3, 8>& corners) {
    const Camera& camera = view.camera;
    const auto [width, height] = view.picture.size;
    const double aspect = static_cast<double>(width) / height;
    const double half =
        camera.orthographic() ? 0.5 * camera.orthographicHeight : std::tan(0.5 * glm::radians(camera.viewAngle));
    double nearest = std::numeric_limits<double>::infinity();
    std::array<bool, 5> beyond;  // the four sides of the picture, and the near plane
    beyond.fill(true);
    for (const glm::dvec3& corner : corners) {
        const glm::dvec3 p{camera.view * glm::dvec4{corner, 1.0}};
        const double reach = half * (camera.orthographic() ? 1.0 : -p.z);
        nearest = std::min(nearest, -p.z);
        const std::array is{p.x > reach * aspect, p.x<-reach * aspect, p.y> reach, p.y < -reach, -p.z < camera.near};
        for (std::size_t i = 0; i < is.size(); ++i) beyond[i] = beyond[i] && is[i];
    }
    if (std::ranges::find(beyond, true) != beyond.end()) return std::numeric_limits<double>::infinity();
    return 2.0 * half / height * (camera.orthographic() ? 1.0 : std::max(nearest, camera.near));
}

}  // namespace

Fineness finenessFor(const Outline& outline, glm::dvec3 up, const LoadSettings& settings) {
    Fineness fineness{std::vector<double>(outline.parts.size(), std::numeric_limits<double>::infinity())};
    if (std::ranges::all_of(outline.parts, [](const auto& points) { return usable(points).empty(); })) return fineness;
    const Scene scene = standIn(outline, up, settings);
    const std::vector<FramedView> views = framedViews(scene, settings);
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.instances().size(); ++i) {
        const glm::dmat4& transform = scene.instances()[i].transform;
        const std::uint32_t mesh = scene.instances()[i].mesh;
        const glm::dvec3 origin = scene.meshes()[mesh].origin;
        auto corners = cornersOf(scene.meshBox(mesh));
        for (glm::dvec3& corner : corners) corner = glm::dvec3{transform * glm::dvec4{corner + origin, 1.0}};
        const double scale = std::max({glm::length(glm::dvec3{transform[0]}), glm::length(glm::dvec3{transform[1]}),
                                       glm::length(glm::dvec3{transform[2]}), 1e-300});
        for (const FramedView& view : views) {
            const double deflection = settings.tolerance * footprintIn(view, corners) / scale;
            fineness.deflections[mesh] = std::min(fineness.deflections[mesh], deflection);
            smallest = std::min(smallest, deflection);
        }
    }
    const double size = 2.0 * scene.bounds().radius;
    if (!std::isfinite(smallest)) smallest = settings.tolerance * 1e-3 * size;
    for (double& deflection : fineness.deflections)
        deflection = std::max(std::min(deflection, unseen * smallest), finest * size);
    return fineness;
}

}  // namespace inkedge::cad
