#include "reference/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>

#include "reference/raster.h"
#include "scene/face_edges.h"
#include "scene/world_triangles.h"

namespace inkedge::reference {
namespace {

using scene::EdgeFlag;
using scene::FaceEdges;

constexpr double lift = 0.25;  // footprints

// A corner in the picture.
struct Corner {
    glm::dvec2 pixel{0.0};
    double window = 0.0;  // depth
    double w = 0.0;       // clip space
};

class Drawing {
public:
    Drawing(const Scene& scene, const Camera& camera, double width, Size size)
        : scene_{scene},
          camera_{camera},
          width_{width},
          size_{size},
          faces_{scene::faceEdgesOf(scene)},
          ink_{size, 1},
          windowDepth_{size, 1, 1.0} {
        const glm::dmat3 toWorld = glm::transpose(glm::dmat3{camera.view});
        const double radius = scene.bounds().radius > 0.0 ? scene.bounds().radius : 1.0;
        eye_ = camera.orthographic()
                   ? glm::dvec4{toWorld[2], 0.0}
                   : glm::dvec4{(-(toWorld * glm::dvec3{camera.view[3]}) - scene.bounds().centre) / radius, 1.0};
    }

    Image<std::uint8_t> draw() && {
        std::uint32_t face = 0;
        for (const Instance& instance : scene_.instances()) {
            const scene::WorldTriangles triangles{scene_, instance, scene_.bounds().centre};
            for (std::uint32_t t = 0; t < triangles.count(); ++t) drawFace(triangles.triangle(t), face++);
        }
        return std::move(ink_);
    }

private:
    using Corners = std::array<glm::dvec3, 3>;  // view space

    [[nodiscard]] double facing(std::uint32_t face) const {
        const glm::dvec4 plane{faces_[face].plane};
        return glm::dot(glm::dvec3{plane}, glm::dvec3{eye_}) - plane.w * eye_.w;
    }

    void drawFace(const std::array<glm::dvec3, 3>& world, std::uint32_t number) {
        Corners corners{};
        ClipTriangle clip{};
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = glm::dvec3{camera_.view * glm::dvec4{world[i] + scene_.bounds().centre, 1.0}};
            clip[i] = camera_.projection(size_) * glm::dvec4{corners[i], 1.0};
        }
        const FaceEdges& face = faces_[number];
        const double side = facing(number);
        const bool isBack = (side < 0.0) != face.has(EdgeFlag::Mirrored);
        const bool hidden = face.has(EdgeFlag::OneSided) && isBack;
        if (!hidden) forEachSample(clip, windowDepth_, [&](const Sample& s) { ink_(s.x, s.y) = 0; });
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t beyond = face.beyond[k];
            const double sign = face.has(EdgeFlag::Reversed, k) ? -1.0 : 1.0;
            const double other = beyond == scene::noFace ? 0.0 : sign * facing(beyond);
            const bool silhouette = side < 0.0 && other > 0.0;
            if (silhouette || (!hidden && face.has(EdgeFlag::Border, k)))
                enlarge(corners, k, side);
            else if (!hidden && face.has(EdgeFlag::Crease, k) && side * other >= 0.0)
                addFin(corners, k);
        }
    }

    // @param footprints  that it lies nearer
    [[nodiscard]] Corner cornerOf(glm::dvec3 position, double footprints) const {
        const double nearer = footprints / camera_.focalLength(size_);
        const glm::dvec4 unmoved = camera_.projection(size_) * glm::dvec4{position, 1.0};
        if (camera_.orthographic())
            position.z += nearer;
        else
            position *= 1.0 - nearer;  // towards the eye: the pixel stays
        const glm::dvec4 clip = camera_.projection(size_) * glm::dvec4{position, 1.0};
        const glm::dvec2 ndc = glm::dvec2{unmoved} / unmoved.w;
        return {{(0.5 + 0.5 * ndc.x) * size_.width, (0.5 - 0.5 * ndc.y) * size_.height},
                0.5 * clip.z / clip.w + 0.5,
                unmoved.w};
    }

    void enlarge(const Corners& corners, std::uint32_t k, double side) {
        const Corner a = cornerOf(corners[k], -lift);
        const Corner b = cornerOf(corners[(k + 1) % 3], -lift);
        const double length = glm::distance(a.pixel, b.pixel);
        if (a.w <= 0.0 || b.w <= 0.0 || length == 0.0) return;
        const glm::dvec2 along = (b.pixel - a.pixel) / length;
        drawStrip(a, b, side > 0.0 ? glm::dvec2{-along.y, along.x} : glm::dvec2{along.y, -along.x}, {0.0, 0.0}, width_);
    }

    void addFin(const Corners& corners, std::uint32_t k) {
        const Corner a = cornerOf(corners[k], lift);
        const Corner b = cornerOf(corners[(k + 1) % 3], lift);
        const Corner c = cornerOf(corners[(k + 2) % 3], lift);
        const double length = glm::distance(a.pixel, b.pixel);
        if (std::min({a.w, b.w, c.w}) <= 0.0 || length == 0.0) return;
        const glm::dvec2 along = (b.pixel - a.pixel) / length;
        const double foot = glm::dot(c.pixel - a.pixel, along);
        const glm::dvec2 into = c.pixel - a.pixel - foot * along;
        const double height = glm::length(into);
        if (height < 0.01) return;
        const double reach = 0.5 * width_;
        const double slopeAlong = (b.window - a.window) / length;
        const double slopeAcross = (c.window - a.window - foot * slopeAlong) / height;
        drawStrip(a, b, into / height,
                  {slopeAlong * std::min(length / reach, 1.0), slopeAcross * std::min(height / reach, 1.0)}, reach);
    }

    // @param slope  of depth along the edge and across it, a pixel
    void drawStrip(const Corner& a, const Corner& b, glm::dvec2 across, glm::dvec2 slope, double reach) {
        const glm::dvec2 along = glm::normalize(b.pixel - a.pixel);
        const auto clipAt = [&](const Corner& end, double forward, double sideways) {
            const glm::dvec2 pixel = end.pixel + forward * along + sideways * across;
            const double window = end.window + forward * slope.x + sideways * slope.y;
            return glm::dvec4{2.0 * pixel.x / size_.width - 1.0, 1.0 - 2.0 * pixel.y / size_.height, 2.0 * window - 1.0,
                              1.0};
        };
        const auto covers = [&](int x, int y) {
            const glm::dvec2 offset = glm::dvec2{x + 0.5, y + 0.5} - a.pixel;
            const double forward = std::clamp(glm::dot(offset, along), 0.0, glm::distance(a.pixel, b.pixel));
            return glm::distance(offset, forward * along) <= reach;
        };
        const std::array<glm::dvec4, 4> quad{clipAt(a, -reach, 0.0), clipAt(b, reach, 0.0), clipAt(a, -reach, reach),
                                             clipAt(b, reach, reach)};
        const auto inked = [&](const Sample& s) { ink_(s.x, s.y) = 255; };
        forEachSample({quad[0], quad[1], quad[2]}, windowDepth_, covers, inked);
        forEachSample({quad[1], quad[2], quad[3]}, windowDepth_, covers, inked);
    }

    const Scene& scene_;
    const Camera& camera_;
    double width_;
    Size size_;
    std::vector<FaceEdges> faces_;
    Image<std::uint8_t> ink_;
    Image<double> windowDepth_;
    glm::dvec4 eye_{0.0};
};

}  // namespace

Image<std::uint8_t> drawFattened(const Scene& scene, const Camera& camera, double width, Size size) {
    return Drawing{scene, camera, width, size}.draw();
}

}  // namespace inkedge::reference
