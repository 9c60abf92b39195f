#include "reference/reference.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <inkedge/error.h>

#include "raster/plane_pairs.h"
#include "reference/raster.h"
#include "settings/picture_channels.h"

namespace inkedge::reference {
namespace {

void drawTriangle(const ClipTriangle& triangle, const std::array<glm::dvec3, 3>& normals, const Camera& camera,
                  Surface& surface) {
    forEachSample(triangle, surface.windowDepth, [&](const Sample& sample) {
        const auto& [x, y, barycentric, window, w, front] = sample;
        glm::dvec3 normal{0.0};
        for (int i = 0; i < 3; ++i) normal += barycentric[i] * normals[static_cast<std::size_t>(i)];
        surface.depth(x, y) = camera.orthographic() ? camera.near + window * (camera.far - camera.near) : w;
        const double length = glm::length(normal);
        for (int i = 0; i < 3; ++i) surface.normal(x, y, i) = normal[i] / length * (front ? 1.0 : -1.0);
    });
}

void requireSameSize(Size a, Size b) {
    if (a == b) return;
    throw Error{Error::Kind::Usage, fmt::format("expected a depth and a normal map of one size, found {}x{} and {}x{}",
                                                a.width, a.height, b.width, b.height)};
}

Image<std::uint8_t> threshold(const Image<double>& magnitude, double t) {
    Image<std::uint8_t> edges{magnitude.size(), 1};
    std::ranges::transform(magnitude.pixels(), edges.mutablePixels().begin(),
                           [&](double m) { return static_cast<std::uint8_t>(m >= t ? 255 : 0); });
    return edges;
}

}  // namespace

Surface drawSurface(const Scene& scene, const Camera& camera, LightSpace lightSpace, Size size) {
    Surface surface{{size, 1, camera.far}, {size, 1, 1.0}, {size, 3, 0.0}};
    const glm::dmat4 viewProjection = camera.projection(size) * camera.view;
    for (const Instance& instance : scene.instances()) {
        const Mesh& mesh = scene.meshes()[instance.mesh];
        const glm::dmat3 toLights = lightSpace == LightSpace::World ? glm::dmat3{instance.transform}
                                                                    : glm::dmat3{camera.view * instance.transform};
        const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(toLights));
        const bool mirrored = glm::determinant(glm::dmat3{instance.transform}) < 0.0;
        for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
            ClipTriangle triangle{};
            std::array<glm::dvec3, 3> normals{};  // light space, unit
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = mesh.indices[t + i];
                const glm::dvec3 position = mesh.origin + glm::dvec3{mesh.positions[vertex]};
                const std::size_t corner = mirrored ? 2 - i : i;
                triangle[corner] = viewProjection * (instance.transform * glm::dvec4{position, 1.0});
                normals[corner] = normalMatrix * glm::dvec3{mesh.normals[vertex]};
            }
            drawTriangle(triangle, normals, camera, surface);
        }
    }
    return surface;
}

glm::dvec3 sixLights(glm::dvec3 n) noexcept {
    glm::dvec3 light{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        light[axis] += std::max(n[axis], 0.0);   // the light on the positive half of the axis
        light[axis] -= std::max(-n[axis], 0.0);  // the negative light on the other half
    }
    return light;
}

Image<double> scaledDepth(const Image<double>& depth, const Camera& camera, DepthMap map) {
    Image<double> scaled = depth;
    for (double& z : scaled.mutablePixels()) {
        const double linear = (z - camera.near) / (camera.far - camera.near);
        z = map == DepthMap::Linear || camera.orthographic() ? linear : linear * camera.far / z;
    }
    return scaled;
}

Image<double> gradientMagnitude(const Image<double>& image, int channel, Kernel kernel) {
    if (channel < 0 || channel >= image.channels()) {
        throw Error{Error::Kind::Usage,
                    fmt::format("expected a channel below {}, found {}", image.channels(), channel)};
    }
    const std::span<const double> smoothing =
        kernel == Kernel::Sobel ? std::span<const double>{sobelSmoothing} : std::span<const double>{faridSmoothing};
    const std::span<const double> derivative =
        kernel == Kernel::Sobel ? std::span<const double>{sobelDerivative} : std::span<const double>{faridDerivative};
    const int radius = static_cast<int>(smoothing.size()) / 2;
    const auto [width, height] = image.size();
    Image<double> magnitude{image.size(), 1};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double ix = 0.0;
            double iy = 0.0;
            for (int dy = -radius; dy <= radius; ++dy) {
                for (int dx = -radius; dx <= radius; ++dx) {
                    const double value =
                        image(std::clamp(x + dx, 0, width - 1), std::clamp(y + dy, 0, height - 1), channel);
                    const auto column = static_cast<std::size_t>(dx + radius);
                    const auto row = static_cast<std::size_t>(dy + radius);
                    ix += derivative[column] * smoothing[row] * value;
                    iy += smoothing[column] * derivative[row] * value;
                }
            }
            magnitude(x, y) = std::sqrt(ix * ix + iy * iy);
        }
    }
    return magnitude;
}

Edges detectEdges(const Image<double>& depth, const Image<double>& normal, const Camera& camera,
                  const DetectorSettings& settings) {
    requireSameSize(depth.size(), normal.size());
    Edges result;
    result.depthMagnitude = gradientMagnitude(scaledDepth(depth, camera, settings.depthMap), 0, settings.kernel);
    result.normalMagnitude = Image<double>{normal.size(), 1};
    for (int channel = 0; channel < 3; ++channel) {
        const Image<double> one = gradientMagnitude(normal, channel, settings.kernel);
        std::ranges::transform(one.pixels(), result.normalMagnitude.pixels(),
                               result.normalMagnitude.mutablePixels().begin(),
                               [](double a, double b) { return std::max(a, b); });
    }
    result.depthEdges = threshold(result.depthMagnitude, static_cast<double>(thresholds(settings).depth));
    result.normalEdges = threshold(result.normalMagnitude, static_cast<double>(thresholds(settings).normal));
    result.edges = result.depthEdges;
    std::ranges::transform(result.normalEdges.pixels(), result.edges.pixels(), result.edges.mutablePixels().begin(),
                           [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    return result;
}

Image<std::uint8_t> detectLines(const Image<float>& planes, double focalLength, bool orthographic, double creaseAngle,
                                double pixelAspect) {
    if (planes.channels() != 4) {
        throw Error{Error::Kind::Usage, fmt::format("expected planes of 4 channels, found {}", planes.channels())};
    }
    const auto [width, height] = planes.size();
    const raster::PlaneView view{
        {focalLength / pixelAspect, focalLength}, orthographic, std::cos(glm::radians(creaseAngle))};
    const glm::dvec2 centre{0.5 * width, 0.5 * height};
    const auto seen = [&](int x, int y) -> raster::SeenPlane {
        const auto value = [&](int channel) { return static_cast<double>(planes(x, y, channel)); };
        return {value(0), {value(1), value(2)}, value(3), glm::dvec2{x + 0.5, y + 0.5} - centre};
    };
    Image<std::uint8_t> marks{planes.size(), 1};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const unsigned right = x + 1 < width ? pairMarks(seen(x, y), seen(x + 1, y), 0, view) : 0;
            const unsigned below = y + 1 < height ? pairMarks(seen(x, y), seen(x, y + 1), 1, view) : 0;
            marks(x, y) = static_cast<std::uint8_t>(right | below << 4U);
        }
    }
    return marks;
}

namespace {

// Depths around a pixel less that of the pixel, in footprints of the pixel.
using Depths = std::array<std::array<double, 5>, 5>;

double gradient(const Depths& d, std::size_t x, std::size_t y) {
    const auto across = [&](std::size_t row) { return d[row][x - 1] + 2.0 * d[row][x] + d[row][x + 1]; };
    const auto along = [&](std::size_t column) { return d[y - 1][column] + 2.0 * d[y][column] + d[y + 1][column]; };
    return (std::abs(across(y - 1) - across(y + 1)) + std::abs(along(x + 1) - along(x - 1))) / 8.0;
}

}  // namespace

Image<double> detectProfiles(const Image<double>& depth, const Image<double>& normal, const Camera& camera,
                             const DetectorSettings& settings) {
    constexpr double far = 1000.0;
    const auto [width, height] = depth.size();
    const double focal = camera.focalLength(depth.size());
    const auto isBackground = [&](int x, int y) {
        return normal(x, y, 0) == 0.0 && normal(x, y, 1) == 0.0 && normal(x, y, 2) == 0.0;
    };
    Image<double> ink{depth.size(), 1};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (isBackground(x, y)) continue;
            const double centre = depth(x, y);
            Depths d{};
            for (int i = 0; i < 25; ++i) {
                const int column = std::clamp(x + i % 5 - 2, 0, width - 1);
                const int row = std::clamp(y + i / 5 - 2, 0, height - 1);
                const double z = depth(column, row);
                const double there = focal * (camera.orthographic() ? z - centre : 1.0 - centre / z);
                d[static_cast<std::size_t>(i / 5)][static_cast<std::size_t>(i % 5)] =
                    isBackground(column, row) ? far : std::clamp(there, -far, far);
            }
            double smallest = gradient(d, 2, 2);
            double largest = smallest;
            double around = 0.0;
            for (std::size_t i = 0; i < 9; ++i) {
                const double g = gradient(d, 1 + i % 3, 1 + i / 3);
                smallest = std::min(smallest, g);
                largest = std::max(largest, g);
                around += d[1 + i / 3][1 + i % 3];
            }
            const double profile = std::min((largest - smallest) / settings.profileLimit, 1.0);
            const double edge = std::min(std::abs(9.0 * d[2][2] - around) / 3.0 / settings.edgeLimit, 1.0);
            ink(x, y) = std::max(profile, edge) * std::max(profile, edge);
        }
    }
    return ink;
}

Image<std::uint8_t> composite(const Image<std::uint8_t>& edges, const PictureSettings& settings) {
    const Color behind = settings.background.value_or(settings.lineColor);
    Image<std::uint8_t> picture{edges.size(), settings::pictureChannels(settings)};
    for (int y = 0; y < edges.size().height; ++y) {
        for (int x = 0; x < edges.size().width; ++x) {
            const bool edge = edges(x, y) != 0;
            const Color color = edge ? settings.lineColor : behind;
            const std::uint8_t channels[4]{color.red, color.green, color.blue,
                                           static_cast<std::uint8_t>(edge || settings.background ? 255 : 0)};
            std::copy_n(channels, picture.channels(), &picture(x, y));
        }
    }
    return picture;
}

}  // namespace inkedge::reference
