// Lines of image space where parts touch: one type along the whole border, at its place, whichever part a sample sees.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <glm/common.hpp>

#include "gl/gl_test.h"
#include "scenes.h"

namespace inkedge::trace {
namespace {

INKEDGE_ON_EACH_BACKEND(ContactLines);

using Polyline = std::vector<glm::dvec3>;

// Parts that touch, and the borders along which they do: those that are seen from the front, above.
struct Contact {
    std::string name;
    std::vector<std::pair<Mesh, glm::dmat4>> parts;
    std::vector<Polyline> borders;
    std::vector<glm::dvec3> corners;  // of the borders, where other lines may begin
};

void append(Mesh& mesh, const Mesh& part, const glm::dmat4& transform) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3 p : part.positions) mesh.positions.emplace_back(transform * glm::dvec4{p, 1.0});
    for (const std::uint32_t i : part.indices) mesh.indices.push_back(first + i);
}

Scene inOneMesh(const std::vector<std::pair<Mesh, glm::dmat4>>& parts) {
    Mesh mesh;
    for (const auto& [part, transform] : parts) append(mesh, part, transform);
    return scenes::sceneOf(mesh);
}

constexpr int sides = 40;

glm::dvec3 onRim(int i, double radius, double y, int count = sides) {
    const double angle = 2.0 * std::numbers::pi * i / count;
    return {radius * std::sin(angle), y, radius * std::cos(angle)};
}

// A closed prism of many sides, about the y axis, from y = 0 up.
Mesh prism(double radius, double height) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, static_cast<float>(height), 0}};
    for (int i = 0; i < sides; ++i)
        for (const double y : {0.0, height}) mesh.positions.emplace_back(onRim(i, radius, y));
    for (std::uint32_t i = 0; i < sides; ++i) {
        const std::uint32_t a = 2 + 2 * i;
        const std::uint32_t b = 2 + 2 * ((i + 1) % sides);
        mesh.indices.insert(mesh.indices.end(), {a, b, b + 1, a, b + 1, a + 1, 0, b, a, 1, a + 1, b + 1});
    }
    return mesh;
}

Contact neighbours(double shorter) {
    const Polyline border{{0, 1 - shorter, -1}, {0, 1 - shorter, 1}, {0, shorter - 1, 1}};
    return {"neighbours, the right one shorter by " + std::to_string(shorter),
            {{scenes::box({1, 2, 2}), scenes::translation({-0.5, 0, 0})},
             {scenes::box({1, 2 - 2 * shorter, 2}), scenes::translation({0.5, 0, 0})}},
            {border},
            border};
}

Contact sheetOnSlab(double gap) {
    const auto y = static_cast<float>(gap);
    const Polyline border{{-0.5, gap, -0.4}, {-0.5, gap, 0.5}, {0.6, gap, 0.5}, {0.6, gap, -0.4}, {-0.5, gap, -0.4}};
    return {"a sheet at " + std::to_string(gap),
            {{scenes::box({2, 1, 2}), scenes::translation({0, -0.5, 0})},
             {scenes::quad({-0.5, y, -0.4}, {-0.5, y, 0.5}, {0.6, y, 0.5}, {0.6, y, -0.4}), glm::dmat4{1.0}}},
            {border},
            {}};
}

// The foot of a cylinder, as far as a camera sees it.
Contact prismOnSlab(const Camera& camera) {
    const glm::dmat4 toWorld = glm::inverse(camera.view);
    const auto isSeen = [&](int i) {
        const glm::dvec3 middle = onRim(2 * i + 1, 0.6, 0.0, 2 * sides);
        const glm::dvec3 towardsEye = glm::dvec3{toWorld[2]} * (camera.orthographic() ? 1.0 : 0.0) +
                                      (glm::dvec3{toWorld[3]} - middle) * (camera.orthographic() ? 0.0 : 1.0);
        return glm::dot(middle, towardsEye) > 0.0;
    };
    Polyline foot;
    for (int i = 0; i < 2 * sides; ++i) {  // once around, from where it is hidden
        if (foot.empty() && (!isSeen(i) || isSeen(i - 1))) continue;
        foot.push_back(onRim(i, 0.6, 0.0));
        if (!isSeen(i)) break;
    }
    return {"a cylinder's foot",
            {{scenes::box({2, 1, 2}), scenes::translation({0, -0.5, 0})}, {prism(0.6, 0.8), glm::dmat4{1.0}}},
            {foot},
            {foot.front(), foot.back()}};
}

double distanceTo(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b) {
    const glm::dvec2 along = b - a;
    const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
    return glm::distance(p, a + t * along);
}

// What is drawn along a border, and where it strays.
struct Along {
    double expected = 0.0;  // pixels of the border
    double contact = 0.0;   // of intersection
    double others = 0.0;    // of other types, where no other line of the scene is near
    double farthest = 0.0;  // intersection from the border
};

Along along(const Lines& lines, const Contact& contact, const Camera& camera) {
    constexpr double near = 0.75;        // pixels
    constexpr double fromCorner = 20.0;  // pixels: a foot leaves its cylinder's contour along the contour
    std::vector<std::vector<glm::dvec2>> borders;
    Along result;
    for (const Polyline& border : contact.borders) {
        std::vector<glm::dvec2>& pixels = borders.emplace_back();
        for (const glm::dvec3& p : border) pixels.push_back(scenes::pixel(camera, lines.size, p));
        for (std::size_t i = 1; i < pixels.size(); ++i) result.expected += glm::distance(pixels[i - 1], pixels[i]);
    }
    const auto fromBorder = [&](glm::dvec2 p) {
        double nearest = 1e9;
        for (const auto& b : borders)
            for (std::size_t i = 1; i < b.size(); ++i) nearest = std::min(nearest, distanceTo(p, b[i - 1], b[i]));
        return nearest;
    };
    const auto isAtCorner = [&](glm::dvec2 p) {
        return std::ranges::any_of(contact.corners, [&](const glm::dvec3& corner) {
            return glm::distance(p, scenes::pixel(camera, lines.size, corner)) < fromCorner;
        });
    };
    for (const Line& line : lines.lines) {
        const std::size_t pieces = line.points.size() - (line.closed ? 0 : 1);
        for (std::size_t i = 0; i < pieces; ++i) {
            const glm::dvec2 a = line.points[i].pixel;
            const glm::dvec2 b = line.points[(i + 1) % line.points.size()].pixel;
            const int count = std::max(1, static_cast<int>(std::ceil(2.0 * glm::distance(a, b))));
            for (int k = 0; k < count; ++k) {
                const glm::dvec2 p = glm::mix(a, b, (k + 0.5) / count);
                const double share = glm::distance(a, b) / count;
                if (line.type == LineType::Intersection) {
                    result.contact += share;
                    result.farthest = std::max(result.farthest, fromBorder(p));
                } else if (fromBorder(p) < near && !isAtCorner(p)) {
                    result.others += share;
                }
            }
        }
    }
    return result;
}

std::vector<CameraSettings> views() {
    std::vector<CameraSettings> all;
    for (const double azimuth : {12.0, 38.0}) {
        for (const double elevation : {29.0, 43.0}) {
            for (const double height : {-1.0, 0.0}) {  // below 0: perspective
                CameraSettings& view = all.emplace_back();
                view.azimuthAngle = azimuth;
                view.elevationAngle = elevation;
                if (height == 0.0) view.orthographicHeight = height;
            }
        }
    }
    return all;
}

// Looks at a contact in one mesh and in two nodes.
// @param contactOf  of a camera
void expectContacts(Renderer& renderer, const CameraSettings& view, int side, const auto& contactOf) {
    Settings settings;
    settings.lines.from = LinesFrom::Image;
    settings.picture.size = {side, side};
    Camera before;
    before.view = scenes::translation({0, 0, -10});
    for (const bool oneMesh : {false, true}) {
        const std::vector<std::pair<Mesh, glm::dmat4>> parts = contactOf(before).parts;
        const Scene scene = oneMesh ? inOneMesh(parts) : scenes::sceneOf(parts);
        const Camera camera = frameCamera(scene, view, settings.picture.size);
        const Contact contact = contactOf(camera);
        SCOPED_TRACE(testing::Message() << contact.name << (oneMesh ? ", one mesh, " : ", two nodes, ")
                                        << *view.azimuthAngle << ", " << *view.elevationAngle
                                        << (camera.orthographic() ? ", orthographic, " : ", ") << side);
        settings.picture.lines = LineTypes{standardLineTypes};
        const Along found = along(renderer.lines(scene, camera, settings), contact, camera);
        EXPECT_NEAR(found.contact, found.expected, 6.0 + 0.01 * found.expected);
        EXPECT_LT(found.farthest, 1.0);
        EXPECT_EQ(found.others, 0.0);

        settings.picture.lines = LineType::Outline | LineType::Occlusion | LineType::Boundary | LineType::Crease;
        const Along without = along(renderer.lines(scene, camera, settings), contact, camera);
        EXPECT_EQ(without.contact, 0.0);
        EXPECT_EQ(without.others, 0.0);
    }
}

TEST_P(ContactLines, areOfOneTypeAlongTheWholeBorder) {
    for (const CameraSettings& view : views()) {
        for (const int side : {211, 400}) {
            for (const Contact& contact :
                 {neighbours(0.0), neighbours(0.3), sheetOnSlab(0.0), sheetOnSlab(1e-6), sheetOnSlab(1e-4)})
                expectContacts(renderer(), view, side, [&](const Camera&) { return contact; });
            expectContacts(renderer(), view, side, prismOnSlab);
        }
    }
}

// A box whose front has vertices at x = t on its long edges, which the faces above and below do not have.
Mesh boxWithTJunctions(float t) {
    Mesh mesh = scenes::box({4, 1, 3});
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {{t, -0.5F, 1.5F}, {t, 0.5F, 1.5F}});
    mesh.indices.resize(mesh.indices.size() - 6);  // the front
    mesh.indices.insert(mesh.indices.end(), {4, first, first + 1, 4, first + 1, 6, first, 5, 7, first, 7, first + 1});
    return mesh;
}

TEST_P(ContactLines, haveNoNicksAtTJunctions) {
    Settings settings;
    settings.lines.from = LinesFrom::Image;
    for (const float t : {-1.3F, 0.1F, 0.7F, 1.9F}) {
        const Scene scene = scenes::sceneOf(boxWithTJunctions(t));
        for (const CameraSettings& view : views()) {
            for (const int side : {211, 300, 480}) {
                settings.picture.size = {side, side};
                const Lines lines = renderer().lines(scene, frameCamera(scene, view, settings.picture.size), settings);
                for (const Line& line : lines.lines) {
                    double length = 0.0;
                    for (std::size_t i = 1; i < line.points.size(); ++i)
                        length += glm::distance(line.points[i - 1].pixel, line.points[i].pixel);
                    EXPECT_GT(length, 2.0) << t << ", " << *view.azimuthAngle << ", " << *view.elevationAngle << ", "
                                           << side << " at " << line.points.front().pixel.x;
                    EXPECT_NE(line.type, LineType::Intersection);
                }
            }
        }
    }
}

}  // namespace
}  // namespace inkedge::trace
