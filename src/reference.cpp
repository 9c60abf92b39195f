#include <inkedge/reference.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>

#include <inkedge/error.h>

namespace inkedge::reference {
namespace {

struct Corner {
    glm::dvec4 clip;
    glm::dvec3 normal;  // light space, unit
};

// A triangle's corners in the order in which the picture shows its front as counter-clockwise.
struct Triangle {
    Corner corners[3];
};

struct PixelRange {
    int begin;
    int end;
};

// The pixels whose centres a triangle may cover along one axis; all of them if it reaches behind the camera.
PixelRange pixelRange(const Triangle& triangle, int axis, int count) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Corner& corner : triangle.corners) {
        if (corner.clip.w <= 0.0) return {0, count};
        const double ndc = corner.clip[axis] / corner.clip.w * (axis == 1 ? -1.0 : 1.0);
        low = std::min(low, (ndc * 0.5 + 0.5) * count);
        high = std::max(high, (ndc * 0.5 + 0.5) * count);
    }
    const auto clamped = [&](double v) { return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(count))); };
    return {clamped(std::floor(low - 1.0)), clamped(std::ceil(high + 1.0))};
}

void drawTriangle(const Triangle& triangle, const Camera& camera, Size size, Surface& surface) {
    // Homogeneous rasterisation: the rows of this inverse are the barycentric edge functions, which need no clipping.
    const auto xyw = [](const glm::dvec4& c) { return glm::dvec3{c.x, c.y, c.w}; };
    const glm::dmat3 corners{xyw(triangle.corners[0].clip), xyw(triangle.corners[1].clip),
                             xyw(triangle.corners[2].clip)};
    const double determinant = glm::determinant(corners);
    if (determinant == 0.0 || !std::isfinite(determinant)) return;
    const glm::dmat3 toBarycentric = glm::inverse(corners);

    const PixelRange rows = pixelRange(triangle, 1, size.height);
    const PixelRange columns = pixelRange(triangle, 0, size.width);
    for (int y = rows.begin; y < rows.end; ++y) {
        for (int x = columns.begin; x < columns.end; ++x) {
            const glm::dvec3 ndc{2.0 * (x + 0.5) / size.width - 1.0, 1.0 - 2.0 * (y + 0.5) / size.height, 1.0};
            const glm::dvec3 weights = toBarycentric * ndc;  // barycentric / w
            const double inverseW = weights.x + weights.y + weights.z;
            if (weights.x < 0.0 || weights.y < 0.0 || weights.z < 0.0 || inverseW <= 0.0) continue;
            const glm::dvec3 barycentric = weights / inverseW;
            double clipZ = 0.0;
            glm::dvec3 normal{0.0};
            for (int i = 0; i < 3; ++i) {
                clipZ += barycentric[i] * triangle.corners[i].clip.z;
                normal += barycentric[i] * triangle.corners[i].normal;
            }
            const double window = 0.5 * clipZ * inverseW + 0.5;
            if (window < 0.0 || window > 1.0 || window >= surface.windowDepth.at(x, y)) continue;
            surface.windowDepth.at(x, y) = window;
            surface.depth.at(x, y) =
                camera.orthographic() ? camera.near + window * (camera.far - camera.near) : 1.0 / inverseW;
            const double length = glm::length(normal);
            for (int i = 0; i < 3; ++i) {
                surface.normal.at(x, y, i) = normal[i] / length * (determinant > 0.0 ? 1.0 : -1.0);
            }
        }
    }
}

void requireSameSize(Size a, Size b) {
    if (a == b) return;
    throw Error{Error::Kind::Usage, fmt::format("expected a depth and a normal map of one size, found {}x{} and {}x{}",
                                                a.width, a.height, b.width, b.height)};
}

Image<std::uint8_t> threshold(const Image<double>& magnitude, double t) {
    Image<std::uint8_t> edges{magnitude.size, 1};
    std::ranges::transform(magnitude.pixels, edges.pixels.begin(),
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
            Triangle triangle{};
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t vertex = mesh.indices[t + i];
                const glm::dvec3 position = mesh.origin + glm::dvec3{mesh.positions[vertex]};
                Corner& corner = triangle.corners[mirrored ? 2 - i : i];
                corner.clip = viewProjection * (instance.transform * glm::dvec4{position, 1.0});
                corner.normal = normalMatrix * glm::dvec3{mesh.normals[vertex]};
            }
            drawTriangle(triangle, camera, size, surface);
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
    for (double& z : scaled.pixels) {
        const double linear = (z - camera.near) / (camera.far - camera.near);
        z = map == DepthMap::Linear || camera.orthographic() ? linear : linear * camera.far / z;
    }
    return scaled;
}

Image<double> gradientMagnitude(const Image<double>& image, int channel, Kernel kernel) {
    if (channel < 0 || channel >= image.channels) {
        throw Error{Error::Kind::Usage, fmt::format("expected a channel below {}, found {}", image.channels, channel)};
    }
    const std::span<const double> smoothing =
        kernel == Kernel::Sobel ? std::span<const double>{sobelSmoothing} : std::span<const double>{faridSmoothing};
    const std::span<const double> derivative =
        kernel == Kernel::Sobel ? std::span<const double>{sobelDerivative} : std::span<const double>{faridDerivative};
    const int radius = static_cast<int>(smoothing.size()) / 2;
    const auto [width, height] = image.size;
    Image<double> magnitude{image.size, 1};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            double ix = 0.0;
            double iy = 0.0;
            for (int dy = -radius; dy <= radius; ++dy) {
                for (int dx = -radius; dx <= radius; ++dx) {
                    const double value =
                        image.at(std::clamp(x + dx, 0, width - 1), std::clamp(y + dy, 0, height - 1), channel);
                    const auto column = static_cast<std::size_t>(dx + radius);
                    const auto row = static_cast<std::size_t>(dy + radius);
                    ix += derivative[column] * smoothing[row] * value;
                    iy += smoothing[column] * derivative[row] * value;
                }
            }
            magnitude.at(x, y) = std::sqrt(ix * ix + iy * iy);
        }
    }
    return magnitude;
}

Edges detectEdges(const Image<double>& depth, const Image<double>& normal, const Camera& camera,
                  const DetectorSettings& settings) {
    requireSameSize(depth.size, normal.size);
    Edges result;
    result.depthMagnitude = gradientMagnitude(scaledDepth(depth, camera, settings.depthMap), 0, settings.kernel);
    result.normalMagnitude = Image<double>{normal.size, 1};
    for (int channel = 0; channel < 3; ++channel) {
        const Image<double> one = gradientMagnitude(normal, channel, settings.kernel);
        std::ranges::transform(one.pixels, result.normalMagnitude.pixels, result.normalMagnitude.pixels.begin(),
                               [](double a, double b) { return std::max(a, b); });
    }
    result.depthEdges = threshold(result.depthMagnitude, static_cast<double>(thresholds(settings).depth));
    result.normalEdges = threshold(result.normalMagnitude, static_cast<double>(thresholds(settings).normal));
    result.edges = result.depthEdges;
    std::ranges::transform(result.normalEdges.pixels, result.edges.pixels, result.edges.pixels.begin(),
                           [](std::uint8_t a, std::uint8_t b) { return std::max(a, b); });
    return result;
}

Image<std::uint8_t> detectLines(const Image<float>& planes, double focalLength, bool orthographic, double creaseAngle) {
    if (planes.channels != 4) {
        throw Error{Error::Kind::Usage, fmt::format("expected planes of 4 channels, found {}", planes.channels)};
    }
    const int width = planes.size.width;
    const int height = planes.size.height;
    const double creaseCosine = std::cos(glm::radians(creaseAngle));
    const auto value = [&](int x, int y, int channel) { return static_cast<double>(planes.at(x, y, channel)); };
    const auto normal = [&](int x, int y) {
        const glm::dvec2 g{value(x, y, 1), value(x, y, 2)};
        const glm::dvec2 fromCentre{x + 0.5 - 0.5 * width, y + 0.5 - 0.5 * height};
        return glm::dvec3{g * focalLength, orthographic ? 1.0 : value(x, y, 0) - glm::dot(g, fromCentre)};
    };
    const auto between = [&](int px, int py, int qx, int qy) -> unsigned {
        if (qx >= width || qy >= height) return 0;
        const double patchP = value(px, py, 3);
        const double patchQ = value(qx, qy, 3);
        if (patchP == 0.0 || patchQ == 0.0) return patchP == patchQ ? 0 : PairMark::background;
        unsigned marks = patchP == patchQ ? 0 : PairMark::patch;

        const glm::dvec3 np = normal(px, py);
        const glm::dvec3 nq = normal(qx, qy);
        if (glm::dot(np, nq) < creaseCosine * glm::length(np) * glm::length(nq)) marks |= PairMark::bend;

        const int axis = qx > px ? 1 : 2;
        const double wp = value(px, py, 0);
        const double wq = value(qx, qy, 0);
        const double gp = value(px, py, axis);
        const double gq = value(qx, qy, axis);
        const double rp = wq - (wp + gp);
        const double rq = wp - (wq - gq);
        const double k = orthographic ? focalLength : focalLength / std::max(wp, wq);
        const double slope = std::min(std::abs(gp), std::abs(gq)) * k;
        if (rp * rq < 0.0 && std::min(std::abs(rp), std::abs(rq)) * k > 1.0 + slope) marks |= PairMark::jump;
        return marks;
    };
    Image<std::uint8_t> marks{planes.size, 1};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            marks.at(x, y) = static_cast<std::uint8_t>(between(x, y, x + 1, y) | between(x, y, x, y + 1) << 4U);
        }
    }
    return marks;
}

Image<std::uint8_t> composite(const Image<std::uint8_t>& edges, const PictureSettings& settings) {
    const Color behind = settings.background.value_or(settings.lineColor);
    const bool grey = settings.background && behind.grey() && settings.lineColor.grey();
    Image<std::uint8_t> picture{edges.size, grey ? 1 : settings.background ? 3 : 4};
    for (int y = 0; y < edges.size.height; ++y) {
        for (int x = 0; x < edges.size.width; ++x) {
            const bool edge = edges.at(x, y) != 0;
            const Color color = edge ? settings.lineColor : behind;
            const std::uint8_t channels[4]{color.red, color.green, color.blue,
                                           static_cast<std::uint8_t>(edge || settings.background ? 255 : 0)};
            std::copy_n(channels, picture.channels, &picture.at(x, y));
        }
    }
    return picture;
}

}  // namespace inkedge::reference
