#include "reference/reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "reference/raster.h"
#include "reference/srgb.h"

namespace inkedge::reference {
namespace {

constexpr glm::dvec3 cool{0.0, 0.0, 0.4};
constexpr glm::dvec3 warm{0.3, 0.3, 0.0};
constexpr double coolShare = 0.35;  // of the base colour
constexpr double warmShare = 0.65;
constexpr double ambient = 0.2;

// The normals of the faces that pixels see: view space, unit, turned to the eye.
Image<double> drawFaceNormals(const Scene& scene, const Camera& camera, Size size) {
    Image<double> normals{size, 3};
    Image<double> windowDepth{size, 1, 1.0};
    for (const Instance& instance : scene.instances()) {
        const Mesh& mesh = scene.meshes()[instance.mesh];
        const glm::dmat4 modelView = camera.view * instance.transform;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            std::array<glm::dvec3, 3> corners{};
            ClipTriangle triangle{};
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec3 position = mesh.origin + glm::dvec3{mesh.positions[mesh.indices[t + i]]};
                corners[i] = glm::dvec3{modelView * glm::dvec4{position, 1.0}};
                triangle[i] = camera.projection(size) * glm::dvec4{corners[i], 1.0};
            }
            glm::dvec3 normal = glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
            const glm::dvec3 towardsEye = camera.orthographic() ? glm::dvec3{0.0, 0.0, 1.0} : -corners[0];
            if (glm::dot(normal, towardsEye) < 0.0) normal = -normal;
            forEachSample(triangle, windowDepth, [&](const Sample& sample) {
                for (int c = 0; c < 3; ++c) normals(sample.x, sample.y, c) = normal[c];
            });
        }
    }
    return normals;
}

glm::dvec3 colorOf(Shade shade, glm::dvec3 paint, double towards) {
    if (shade == Shade::BaseColor) return paint;
    if (shade == Shade::Gooch) {
        const glm::dvec3 from = glm::min(cool + coolShare * paint, 1.0);
        return glm::mix(from, glm::min(warm + warmShare * paint, 1.0), 0.5 + 0.5 * towards);
    }
    const double light = ambient + (1.0 - ambient) * std::max(towards, 0.0);
    return {toSrgb(light * toLinear(paint.r)), toSrgb(light * toLinear(paint.g)), toSrgb(light * toLinear(paint.b))};
}

}  // namespace

Image<double> drawShade(const Scene& scene, const Camera& camera, Shade shade, glm::dvec3 towardsLight, Size size) {
    constexpr double nothing = 1e29;  // of drawFunction(): there is no value
    const Image<double> paints = drawFunction(scene, camera, surfaceFunction("base-color"), size);
    const Image<double> normals = shade == Shade::Flat ? drawFaceNormals(scene, camera, size)
                                                       : drawFunction(scene, camera, surfaceFunction("normal"), size);
    Image<double> colors{size, 4};
    for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
            if (paints(x, y, 3) > nothing) continue;
            const glm::dvec3 normal{normals(x, y, 0), normals(x, y, 1), normals(x, y, 2)};
            const glm::dvec3 paint{paints(x, y, 0), paints(x, y, 1), paints(x, y, 2)};
            const glm::dvec3 color = colorOf(shade, paint, glm::dot(normal, towardsLight));
            for (int c = 0; c < 3; ++c) colors(x, y, c) = color[c];
            colors(x, y, 3) = 1.0;
        }
    }
    return colors;
}

}  // namespace inkedge::reference
