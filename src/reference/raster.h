#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <inkedge/image.h>

namespace inkedge::reference {

/// A triangle's corners in clip space, in the order in which the picture shows its front as counter-clockwise.
using ClipTriangle = std::array<glm::dvec4, 3>;

/// The point of a triangle that a pixel's centre sees.
struct Sample {
    int x;
    int y;
    glm::dvec3 barycentric;  ///< weights of the corners
    double window;           ///< window-space depth
    double w;                ///< clip-space w
    bool front;
};

struct PixelRange {
    int begin;
    int end;
};

/// The pixels whose centres a triangle may cover along one axis; all of them if it reaches behind the camera.
inline PixelRange pixelRange(const ClipTriangle& triangle, int axis, int count) {
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const glm::dvec4& clip : triangle) {
        if (clip.w <= 0.0) return {0, count};
        const double ndc = clip[axis] / clip.w * (axis == 1 ? -1.0 : 1.0);
        low = std::min(low, (ndc * 0.5 + 0.5) * count);
        high = std::max(high, (ndc * 0.5 + 0.5) * count);
    }
    const auto clamped = [&](double v) { return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(count))); };
    return {clamped(std::floor(low - 1.0)), clamped(std::ceil(high + 1.0))};
}

/// Calls draw(Sample) for each pixel whose centre sees the triangle nearer than windowDepth, and keeps its depth there.
/// @param covers  of a pixel, x and y: whether the triangle is drawn there
template <class Covers, class Draw>
void forEachSample(const ClipTriangle& triangle, Image<double>& windowDepth, Covers&& covers, Draw&& draw) {
    // Homogeneous rasterisation: the rows of this inverse are the barycentric edge functions, which need no clipping.
    const auto xyw = [](const glm::dvec4& c) { return glm::dvec3{c.x, c.y, c.w}; };
    const glm::dmat3 corners{xyw(triangle[0]), xyw(triangle[1]), xyw(triangle[2])};
    const double determinant = glm::determinant(corners);
    if (determinant == 0.0 || !std::isfinite(determinant)) return;
    const glm::dmat3 toBarycentric = glm::inverse(corners);

    const Size size = windowDepth.size();
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
            for (int i = 0; i < 3; ++i) clipZ += barycentric[i] * triangle[static_cast<std::size_t>(i)].z;
            const double window = 0.5 * clipZ * inverseW + 0.5;
            if (window < 0.0 || window > 1.0 || window >= windowDepth(x, y) || !covers(x, y)) continue;
            windowDepth(x, y) = window;
            draw(Sample{x, y, barycentric, window, 1.0 / inverseW, determinant > 0.0});
        }
    }
}

template <class Draw>
void forEachSample(const ClipTriangle& triangle, Image<double>& windowDepth, Draw&& draw) {
    forEachSample(
        triangle, windowDepth, [](int, int) { return true; }, draw);
}

}  // namespace inkedge::reference
