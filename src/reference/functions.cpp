#include "reference/reference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <inkedge/error.h>

#include "reference/raster.h"
#include "reference/srgb.h"
#include "scene/extent.h"

namespace inkedge::reference {
namespace {

constexpr double noValue = 1e30;
constexpr double nothing = 1e29;  // a last channel over this: there is no value

// struct Surface of shaders/shared/surface.glsl.
struct SurfacePoint {
    glm::dvec3 world{0.0};  // from the centre of the scene's bounds
    glm::dvec3 object{0.0};
    glm::dvec3 normal{0.0};
    glm::dvec3 worldNormal{0.0};
    glm::dvec3 fromEye{0.0};
    double depth = 0.0;
    glm::dvec2 coordinates{0.0};
    glm::dvec3 color{1.0};  // of the vertex times that of the material
    double curvature = 0.0;
};

struct Given {
    const Scene& scene;
    const Camera& camera;
    const FunctionSettings& function;
    [[nodiscard]] double option(std::size_t i) const { return function.options.at(i); }
};

double stepsIn(double steps) { return std::floor(steps + 1e-3); }

double wave(glm::dvec3 p) {
    return std::sin(3.1 * p.x + 1.7 * p.z) * std::sin(2.3 * p.y + 0.9 * p.x) + 0.5 * std::sin(4.7 * p.z - 1.3 * p.y);
}

glm::dvec4 depth(const SurfacePoint& s, const Given& given) {
    const DepthMap map = given.option(0) == 1.0 ? DepthMap::Window : DepthMap::Linear;
    const Image<double> z{{1, 1}, 1, s.depth};
    return {scaledDepth(z, given.camera, map).pixels()[0], 0.0, 0.0, 0.0};
}

glm::dvec4 normal(const SurfacePoint& s, const Given& given) {
    return {given.option(0) == 1.0 ? s.worldNormal : s.normal, 0.0};
}

glm::dvec4 texture(const SurfacePoint& s, const Given& given) {
    return {glm::fract(s.coordinates * given.option(0)), 0.0, 0.0};
}

glm::dvec4 baseColor(const SurfacePoint& s, const Given&) {
    const glm::dvec3 c = glm::clamp(s.color, 0.0, 1.0);
    return {toSrgb(c.r), toSrgb(c.g), toSrgb(c.b), 0.0};
}

glm::dvec4 environment(const SurfacePoint& s, const Given& given) {
    glm::dvec3 reflected = glm::reflect(s.fromEye, s.normal);
    if (given.option(0) == 1.0) reflected = glm::transpose(glm::dmat3{given.camera.view}) * reflected;
    return {0.5 + 0.5 * reflected, 0.0};
}

glm::dvec4 volume(const SurfacePoint& s, const Given& given) {
    if (given.option(0) == 0.0) return {given.option(2) * s.object, 0.0};
    const int axis = static_cast<int>(given.option(1));
    glm::dvec3 across = s.object;
    across[axis] = 0.0;
    const double along = given.option(0) == 1.0 ? glm::length(across) : s.object[axis];
    return {stepsIn(given.option(2) * along + given.option(3) * wave(2.0 * s.object)), 0.0, 0.0, 0.0};
}

glm::dvec4 curvature(const SurfacePoint& s, const Given& given) {
    const double scaled = given.option(0) * s.curvature;
    return {stepsIn(given.option(1) * scaled / (1.0 + std::abs(scaled)) + 0.5), 0.0, 0.0, 0.0};
}

glm::dvec4 uv(const SurfacePoint& s, const Given& given) {
    const auto steps = [&](double c) { return stepsIn(glm::fract(c + 1e-6) / given.option(0)); };
    return {given.option(1) == 2.0 ? 0.0 : steps(s.coordinates.x),
            given.option(1) == 1.0 ? 0.0 : steps(s.coordinates.y), 0.0, 0.0};
}

glm::dvec4 height(const SurfacePoint& s, const Given& given) {
    constexpr std::array<glm::dvec3, 3> axes{glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}};
    const auto choice = static_cast<std::size_t>(given.option(0));
    const glm::dvec3 axis = choice < axes.size() ? axes[choice] : given.scene.up();
    const double lowest = -scene::support(given.scene, -axis);
    const double extent = scene::support(given.scene, axis) - lowest;
    const double size = given.option(1) > 0.0 ? given.option(1) : extent / given.option(2);
    const double above = glm::dot(s.world + given.scene.bounds().centre, axis) - lowest;
    return {size > 0.0 ? stepsIn(above / size) : 0.0, 0.0, 0.0, 0.0};
}

using Definition = glm::dvec4 (*)(const SurfacePoint&, const Given&);

Definition definitionOf(const FunctionSettings& function) {
    static const std::map<std::string_view, Definition> all{{"depth", depth},
                                                            {"normal", normal},
                                                            {"texture", texture},
                                                            {"base-color", baseColor},
                                                            {"environment", environment},
                                                            {"volume", volume},
                                                            {"curvature", curvature},
                                                            {"uv", uv},
                                                            {"height", height}};
    const auto found = all.find(function.name);
    if (found != all.end() && function.file.empty()) return found->second;
    throw Error{Error::Kind::Usage, fmt::format("expected a function that reads no file, found '{}'", text(function))};
}

glm::dvec3 materialColor(const Scene& scene, const Mesh& mesh, std::size_t triangle) {
    const std::uint32_t material = mesh.materials.empty() ? 0 : mesh.materials[triangle];
    if (material == 0 || material > scene.materials().size()) return glm::dvec3{1.0};
    if (scene.materials()[material - 1].picture)
        throw Error{Error::Kind::Usage, "expected materials without pictures, found one with a picture"};
    return glm::dvec3{glm::vec3{scene.materials()[material - 1].color}};
}

// The values at a triangle's corner, to be interpolated.
SurfacePoint cornerOf(const Given& given, const Instance& instance, const Mesh& mesh, std::uint32_t vertex) {
    const double unit = given.scene.bounds().radius > 0.0 ? given.scene.bounds().radius : 1.0;
    const glm::dmat3 linear{instance.transform};
    const double radii = std::cbrt(std::abs(glm::determinant(linear))) / unit;
    const glm::dvec3 local{mesh.positions[vertex]};
    SurfacePoint point;
    point.world = glm::dvec3{instance.transform * glm::dvec4{mesh.origin + local, 1.0}} - given.scene.bounds().centre;
    point.object = local * radii;
    point.worldNormal = glm::transpose(glm::inverse(linear)) * glm::dvec3{mesh.normals[vertex]};
    if (!mesh.textureCoordinates.empty()) point.coordinates = glm::dvec2{mesh.textureCoordinates[vertex]};
    if (!mesh.paint.empty()) point.color = glm::dvec3{glm::vec3{mesh.paint[vertex].color}};
    if (!mesh.curvatures.empty()) point.curvature = static_cast<double>(mesh.curvatures[vertex]) / radii;
    return point;
}

SurfacePoint mixed(const std::array<SurfacePoint, 3>& corners, const Sample& sample, const Given& given) {
    SurfacePoint point;
    point.color = glm::dvec3{0.0};
    for (int i = 0; i < 3; ++i) {
        const SurfacePoint& corner = corners[static_cast<std::size_t>(i)];
        const double weight = sample.barycentric[i];
        point.world += weight * corner.world;
        point.object += weight * corner.object;
        point.worldNormal += weight * corner.worldNormal;
        point.coordinates += weight * corner.coordinates;
        point.color += weight * corner.color;
        point.curvature += weight * corner.curvature * (sample.front ? 1.0 : -1.0);
    }
    const glm::dvec3 inView{given.camera.view * glm::dvec4{point.world + given.scene.bounds().centre, 1.0}};
    point.worldNormal = glm::normalize(point.worldNormal) * (sample.front ? 1.0 : -1.0);
    point.normal = glm::dmat3{given.camera.view} * point.worldNormal;
    point.fromEye = given.camera.orthographic() ? glm::dvec3{0.0, 0.0, -1.0} : glm::normalize(inView);
    point.depth = -inView.z;
    return point;
}

// The values of a pixel less those of the centre: functionMagnitude().
glm::dvec4 difference(const Image<double>& values, int x, int y, const glm::dvec4& centre, double period) {
    const int column = std::clamp(x, 0, values.size().width - 1);
    const int row = std::clamp(y, 0, values.size().height - 1);
    glm::dvec4 d{0.0};
    if (values(column, row, 3) > nothing) return d;
    for (int c = 0; c < 4; ++c) {
        d[c] = values(column, row, c) - centre[c];
        if (period > 0.0) d[c] -= period * std::nearbyint(d[c] / period);
    }
    return d;
}

}  // namespace

Image<double> drawFunction(const Scene& scene, const Camera& camera, const FunctionSettings& function, Size size) {
    const Definition definition = definitionOf(function);
    const FunctionDescription& row = functionDescription(function.name);
    const Given given{scene, camera, function};
    Image<double> values{size, 4, 0.0};
    for (std::size_t i = 0; i < values.pixels().size(); i += 4) {
        values.mutablePixels()[i] = static_cast<double>(row.background.value_or(0.0F));
        values.mutablePixels()[i + 3] = row.background ? 0.0 : noValue;
    }
    Image<double> windowDepth{size, 1, 1.0};
    const glm::dmat4 viewProjection = camera.projection(size) * camera.view;
    for (const Instance& instance : scene.instances()) {
        const Mesh& mesh = scene.meshes()[instance.mesh];
        const bool mirrored = glm::determinant(glm::dmat3{instance.transform}) < 0.0;
        for (std::size_t t = 0; t < mesh.indices.size() / 3; ++t) {
            ClipTriangle triangle{};
            std::array<SurfacePoint, 3> corners{};
            const glm::dvec3 color = materialColor(scene, mesh, t);
            for (std::size_t i = 0; i < 3; ++i) {
                SurfacePoint& corner = corners[mirrored ? 2 - i : i];
                corner = cornerOf(given, instance, mesh, mesh.indices[3 * t + i]);
                corner.color *= color;
                triangle[mirrored ? 2 - i : i] = viewProjection * glm::dvec4{corner.world + scene.bounds().centre, 1.0};
            }
            forEachSample(triangle, windowDepth, [&](const Sample& sample) {
                const glm::dvec4 value = definition(mixed(corners, sample, given), given);
                for (int c = 0; c < 4; ++c) values(sample.x, sample.y, c) = value[c];
            });
        }
    }
    return values;
}

Image<double> functionMagnitude(const Image<double>& values, const FunctionSettings& function) {
    const bool sobel = function.kernel == Kernel::Sobel;
    const std::span<const double> smoothing = sobel ? std::span<const double>{sobelSmoothing} : faridSmoothing;
    const std::span<const double> derivative = sobel ? std::span<const double>{sobelDerivative} : faridDerivative;
    const int radius = static_cast<int>(smoothing.size()) / 2;
    Image<double> magnitude{values.size(), 1};
    for (int y = 0; y < values.size().height; ++y) {
        for (int x = 0; x < values.size().width; ++x) {
            if (values(x, y, 3) > nothing) continue;
            const glm::dvec4 centre{values(x, y, 0), values(x, y, 1), values(x, y, 2), values(x, y, 3)};
            glm::dvec4 ix{0.0};
            glm::dvec4 iy{0.0};
            for (int dy = -radius; dy <= radius; ++dy) {
                for (int dx = -radius; dx <= radius; ++dx) {
                    const auto column = static_cast<std::size_t>(dx + radius);
                    const auto row = static_cast<std::size_t>(dy + radius);
                    const glm::dvec4 d = difference(values, x + dx, y + dy, centre, wrapPeriod(function));
                    ix += derivative[column] * smoothing[row] * d;
                    iy += smoothing[column] * derivative[row] * d;
                }
            }
            const glm::dvec4 squared = ix * ix + iy * iy;
            magnitude(x, y) = std::sqrt(std::max({squared.x, squared.y, squared.z, squared.w}));
        }
    }
    return magnitude;
}

}  // namespace inkedge::reference
